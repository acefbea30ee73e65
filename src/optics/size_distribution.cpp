#include "optics/size_distribution.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace airlight {

namespace {

struct LogRange {
    double low;
    double high;
};

double size_parameter(double radius_m, Wavelength wavelength) { return 2.0 * pi * radius_m / as_length(wavelength).in(m); }

// The sizes that matter: the mode of the cross-sectional area and five deviations about it, beyond which are 6e-7 of it.
// Where these are small against the wavelength scattering grows as r^6: on to its mode, or to x = 10 where that growth ends.
LogRange range_that_matters(const LognormalSizes& sizes, Wavelength wavelength) {
    const double s = std::log(sizes.sigma);
    const double mode = std::log(sizes.mode_radius.in(m));
    const double growth_ends = std::log(10.0 / size_parameter(1.0, wavelength));
    const double high = std::max(mode + 2.0 * s * s, std::min(mode + 6.0 * s * s, growth_ends)) + 5.0 * s;
    return {std::max(std::log(sizes.radius_min.in(m)), mode + 2.0 * s * s - 5.0 * s), std::min(std::log(sizes.radius_max.in(m)), high)};
}

}  // namespace

double number_per_log_radius(const LognormalSizes& sizes, Length radius) {
    if (radius < sizes.radius_min || radius > sizes.radius_max) return 0.0;
    const double s = std::log(sizes.sigma);
    const double t = std::log((radius / sizes.mode_radius).value) / s;
    return std::exp(-0.5 * t * t) / (std::sqrt(2.0 * pi) * s);
}

std::size_t series_terms(const LognormalSizes& sizes, Wavelength wavelength) {
    const double x = size_parameter(std::exp(range_that_matters(sizes, wavelength).high), wavelength);
    return mie_term_count(x);
}

MeanParticle mean_particle(const LognormalSizes& sizes, RefractiveIndex index, Wavelength wavelength, const MieAngles& angles,
                           double log_step) {
    assert(sizes.sigma > 1.0 && log_step > 0.0);
    const auto [low, high] = range_that_matters(sizes, wavelength);
    MeanParticle mean{0.0 * m2, 0.0 * m2, 0.0, std::vector<double>(angles.angle_count(), 0.0)};
    if (!(low < high)) return mean;
    // Four steps a deviation at least: with them the midpoint rule integrates a Gaussian to 1e-14.
    const int steps = static_cast<int>(std::ceil((high - low) / std::min(log_step, 0.25 * std::log(sizes.sigma))));
    const double step = (high - low) / steps;
    const double reduced_m = as_length(wavelength).in(m) / (2.0 * pi);
    for (int i = 0; i < steps; ++i) {
        const double radius_m = std::exp(low + (i + 0.5) * step);
        const double share = step * number_per_log_radius(sizes, radius_m * m);
        const MieSeries series = mie_series(size_parameter(radius_m, wavelength), index);
        const MieEfficiencies e = mie_efficiencies(series);
        const Area cross_section = pi * radius_m * radius_m * share * m2;
        mean.scattering += e.qsca * cross_section;
        mean.absorption += e.qabs * cross_section;
        mean.g += e.g * (e.qsca * cross_section).in(m2);
        angles.add_mueller_11(series, share * reduced_m * reduced_m, mean.scattering_m2_sr);
    }
    mean.g /= mean.scattering.in(m2);
    return mean;
}

}  // namespace airlight
