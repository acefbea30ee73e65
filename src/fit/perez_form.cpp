#include "fit/perez_form.h"

#include <algorithm>
#include <cmath>

#include "fit/least_squares.h"

namespace airlight {

namespace {

using Parameters = std::vector<double>;

// Numbers without bounds stand for b < 0, or the horizon would be a pole, and for d below 0.5, or the side of the sky away from
// the sun would grow without end. The scale is in units of the samples' mean.
constexpr double most_d = 0.5;
double distance_to_bound(double u) { return std::exp(std::clamp(u, -6.0, 4.0)); }

PerezForm form_of(std::span<const double> x, double unit) {
    return {{x[0], -distance_to_bound(x[1]), x[2], most_d - distance_to_bound(x[3]), x[4]}, x[5] * unit};
}

double unit_of(std::span<const PerezSample> samples) {
    double sum = 0.0;
    for (const PerezSample& s : samples) sum += s.value / static_cast<double>(samples.size());
    return sum;
}

// From `start`, to which flat directions are tied: a change of a parameter by one costs as much as a difference of `spring` in one
// direction.
LeastSquaresFit search(std::span<const PerezSample> samples, double unit, const Parameters& start, double spring) {
    LeastSquares problem;
    problem.residuals = static_cast<int>(samples.size() + start.size());
    problem.tolerance = 1e-6;
    problem.evaluate = [&](std::span<const double> x, std::span<double> r) {
        const PerezForm form = form_of(x, unit);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const PerezSample& s = samples[i];
            r[i] = s.value > 0.0 ? std::sqrt(s.weight) * (form.value(s.mu, s.nu) / s.value - 1.0) : 0.0;
        }
        for (std::size_t j = 0; j < start.size(); ++j) r[samples.size() + j] = spring * (x[j] - start[j]);
    };
    return least_squares(problem, start);
}

// A clear sky, a hazy one, one that is even, and one that is far brighter at the horizon.
constexpr double starts[][6] = {
    {-1.0, -1.2, 2.0, 1.1, 0.3, 1.0}, {-1.0, -1.2, 8.0, 1.5, 0.3, 0.5}, {-0.2, -1.2, 0.2, 0.4, 0.1, 1.0}, {-1.0, -3.0, 2.0, 1.1, 0.3, 3.0}};

// The nearest of the searches from all of these, and from where another sun's ended.
LeastSquaresFit best(std::span<const PerezSample> samples, double unit, const Parameters* similar) {
    constexpr double spring = 0.01;
    LeastSquaresFit nearest{{}, HUGE_VAL};
    const auto take = [&](const Parameters& start) {
        LeastSquaresFit found = search(samples, unit, start, spring);
        if (found.root_mean_square < nearest.root_mean_square) nearest = std::move(found);
    };
    for (const auto& start : starts) take({std::begin(start), std::end(start)});
    if (similar) take(*similar);
    return nearest;
}

}  // namespace

std::vector<PerezForm> fitted_perez(std::span<const std::vector<PerezSample>> suns) {
    std::vector<PerezForm> forms;
    Parameters last(std::begin(starts[0]), std::end(starts[0]));
    for (const std::vector<PerezSample>& samples : suns) {
        const double unit = unit_of(samples);
        if (unit > 0.0) last = best(samples, unit, forms.empty() ? nullptr : &last).parameters;
        forms.push_back(form_of(last, unit));  // a sky without light is one of scale 0
    }
    return forms;
}

}  // namespace airlight
