#include "fit/preetham_form.h"

#include <algorithm>
#include <cmath>

#include "fit/least_squares.h"
#include "units/units.h"

namespace airlight {

namespace {

// How a coefficient is bounded: b below 0, or the horizon would be a pole; d below 0.5, or the side away from the sun would grow without
// end; chi from 0 to 0.49, for at 0.5 a sun in the zenith is a pole.
enum class Bound { none, b, d, chi };
constexpr double most_d = 0.5, most_chi = 0.49;

double bounded(Bound bound, double u) {
    if (bound == Bound::b) return -std::exp(std::clamp(u, -6.0, 4.0));
    if (bound == Bound::d) return most_d - std::exp(std::clamp(u, -6.0, 4.0));
    if (bound == Bound::chi) return most_chi / (1.0 + std::exp(-u));
    return u;
}
double unbounded(Bound bound, double x) {
    if (bound == Bound::b) return std::log(std::max(-x, 0.05));
    if (bound == Bound::d) return std::log(std::max(most_d - x, 0.05));
    if (bound == Bound::chi) return -std::log(most_chi / std::clamp(x, 0.01, most_chi - 0.01) - 1.0);
    return x;
}

// A coefficient is a polynomial through its values at nodes: of the least and the largest turbidity, so that bounds hold between.
struct Coefficient {
    Bound bound;
    double start;
    bool squared;
};

// Of a clear sky, near the published ones at turbidity 3; the zenith's are in units of the quantity's mean.
constexpr Coefficient luminance_form[] = {{Bound::none, -0.93, false}, {Bound::b, -0.64, false},   {Bound::none, 5.3, false},
                                          {Bound::d, -2.2, false},     {Bound::none, 0.17, false}, {Bound::chi, 0.42, false},
                                          {Bound::none, 0.2, false},   {Bound::none, 0.3, false}};
constexpr Coefficient chromaticity_form[] = {{Bound::none, -0.3, false}, {Bound::b, -0.2, false},    {Bound::none, 0.2, false},
                                             {Bound::d, -1.2, false},    {Bound::none, 0.03, false}, {Bound::none, 0.0, true},
                                             {Bound::none, 0.0, true},   {Bound::none, 0.0, true},   {Bound::none, 1.0, true}};

std::span<const Coefficient> form_of(bool luminance) {
    return luminance ? std::span<const Coefficient>(luminance_form) : std::span<const Coefficient>(chromaticity_form);
}

class Search {
public:
    Search(std::span<const PreethamSky> skies, std::span<const double> turbidities, bool luminance)
        : skies_(skies), luminance_(luminance), low_(turbidities.front()), high_(turbidities.back()) {
        const std::size_t linear = turbidities.size() > 1 ? 2 : 1, squared = std::min<std::size_t>(turbidities.size(), 3);
        for (const Coefficient& c : form_of(luminance)) nodes_.push_back(c.squared ? squared : linear);
        double sum = 0.0, count = 0.0;
        for (const PreethamSky& sky : skies)
            for (const PerezSample& s : sky.samples) sum += s.value, count += 1.0;
        unit_ = sum / count;
    }

    std::vector<TurbidityPolynomial> fitted() const {
        std::vector<double> start;
        for (std::size_t k = 0; k < nodes_.size(); ++k)
            start.insert(start.end(), nodes_[k], unbounded(form_of(luminance_)[k].bound, form_of(luminance_)[k].start));
        std::size_t samples = 0;
        for (const PreethamSky& sky : skies_) samples += sky.samples.size();
        LeastSquares problem{.residuals = static_cast<int>(samples + start.size()), .evaluate = {}, .evaluations = 2000, .tolerance = 1e-6};
        problem.evaluate = [&](std::span<const double> x, std::span<double> r) {
            residuals(x, r.first(samples));
            // Flat directions stay where they began.
            for (std::size_t j = 0; j < start.size(); ++j) r[samples + j] = 0.02 * (x[j] - start[j]);
        };
        return polynomials(least_squares(problem, start).parameters);
    }

private:
    // The nodes of a coefficient in turbidity, 0 at the least to 1 at the largest: 0; 0, 1; or 0, 1/2, 1.
    double at(std::size_t k, std::span<const double> nodes, double s) const {
        const auto value = [&](std::size_t i) { return bounded(form_of(luminance_)[k].bound, nodes[i]); };
        if (nodes.size() == 1) return value(0);
        if (nodes.size() == 2) return std::lerp(value(0), value(1), s);
        return (1.0 - s) * (1.0 - 2.0 * s) * value(0) + 4.0 * s * (1.0 - s) * value(1) + s * (2.0 * s - 1.0) * value(2);
    }

    PreethamQuantity quantity(std::span<const double> x, double turbidity) const {
        const double s = high_ > low_ ? (turbidity - low_) / (high_ - low_) : 0.0;
        std::array<double, 9> k{};
        std::size_t first = 0;
        for (std::size_t i = 0; i < nodes_.size(); first += nodes_[i++]) k[i] = at(i, x.subspan(first, nodes_[i]), s);
        return {{k[0], k[1], k[2], k[3], k[4]}, {k[5], k[6], k[7], k[8]}};
    }

    void residuals(std::span<const double> x, std::span<double> r) const {
        std::size_t i = 0;
        for (const PreethamSky& sky : skies_) {
            const PreethamQuantity q = quantity(x, sky.turbidity);
            const double zenith =
                luminance_ ? 1e-3 * preetham_zenith_luminance(q, sky.sun_zenith) : preetham_zenith_chromaticity(q, sky.sun_zenith);
            // On the way a search may pass where the formula is zero in the zenith.
            const double up = f64::perez(q.k, 1.0, std::cos(sky.sun_zenith), sky.sun_zenith).value;
            const PerezForm form{q.k, unit_ * zenith / (std::abs(up) < 1e-3 ? 1e-3 : up)};
            for (const PerezSample& s : sky.samples)
                r[i++] = s.value > 0.0 ? std::sqrt(s.weight) * (form.value(s.mu, s.nu) / s.value - 1.0) : 0.0;
        }
    }

    std::vector<TurbidityPolynomial> polynomials(std::span<const double> x) const {
        std::vector<TurbidityPolynomial> all;
        std::size_t first = 0;
        for (std::size_t k = 0; k < nodes_.size(); first += nodes_[k++]) {
            const double unit = k < 5 || (luminance_ && k == 5) ? 1.0 : (luminance_ ? 1e-3 * unit_ : unit_);
            const auto value = [&](double s) { return unit * at(k, x.subspan(first, nodes_[k]), s); };
            if (!(high_ > low_)) {
                all.push_back({0.0, 0.0, value(0.0)});
                continue;
            }
            // Through 0, 1/2 and 1 of the range of turbidities, in powers of the turbidity itself.
            const double range = high_ - low_, v0 = value(0.0);
            const double square = nodes_[k] == 3 ? 2.0 * (v0 - 2.0 * value(0.5) + value(1.0)) : 0.0, slope = value(1.0) - v0 - square;
            const double t2 = square / (range * range), t1 = slope / range - 2.0 * t2 * low_;
            all.push_back({t2, t1, v0 - slope / range * low_ + t2 * low_ * low_});
        }
        return all;
    }

    std::span<const PreethamSky> skies_;
    bool luminance_;
    double low_, high_;
    double unit_;                     // the mean of all samples
    std::vector<std::size_t> nodes_;  // of each coefficient
};

}  // namespace

std::vector<TurbidityPolynomial> fitted_preetham(std::span<const PreethamSky> skies, std::span<const double> turbidities, bool luminance) {
    return Search(skies, turbidities, luminance).fitted();
}

}  // namespace airlight
