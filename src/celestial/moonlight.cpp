#include "celestial/moonlight.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "sun/position.h"

namespace airlight {

namespace {

constexpr double first_nm = 300.0, last_nm = 1000.0, step_nm = 5.0;
constexpr double moon_albedo_550 = 0.122;
constexpr double earth_albedo_550 = 2.0 / 3.0 * 0.297;  // geometric, of a Lambertian ball
constexpr Length earth_radius = 6371.0 * km;

template <class F>
SpectrumOf<Number> spectrum_of(const F& value_at_nm) {
    std::vector<SpectrumOf<Number>::Sample> samples;
    for (double nanometres = first_nm; nanometres <= last_nm; nanometres += step_nm)
        samples.push_back({nanometres * nm, value_at_nm(nanometres)});
    return *SpectrumOf<Number>::of(std::move(samples));
}

double moon_albedo_at(double nanometres) {
    const double slope = (1.0 - std::pow(10.0, -0.4 * (0.92 - 0.65))) / (550.0 - 440.0);  // from B to V
    return moon_albedo_550 * (1.0 + slope * (nanometres - 550.0));
}

double earth_albedo_at(double nanometres) {
    const double blue = (std::pow(10.0, 0.4 * (0.65 - 0.20)) - 1.0) / (std::pow(550.0 / 440.0, 4.0) - 1.0);
    return earth_albedo_550 * (1.0 + blue * (std::pow(550.0 / nanometres, 4.0) - 1.0));
}

double squared(double x) { return x * x; }

}  // namespace

double moon_brightness(double phase_angle) {
    assert(phase_angle >= 0.0 && phase_angle <= pi);
    const double a = phase_angle / deg;
    return std::pow(10.0, -0.4 * (0.026 * a + 4e-9 * squared(a * a))) * std::max(1.0, 1.35 - 0.05 * a);
}

double lommel_seeliger_brightness(double phase_angle) {
    assert(phase_angle >= 0.0 && phase_angle <= pi);
    if (phase_angle == 0.0) return 1.0;
    const double half = 0.5 * phase_angle;
    return std::max(0.0, 1.0 + std::sin(half) * std::tan(half) * std::log(std::tan(0.5 * half)));
}

double moon_radiance_factor(double phase_angle) {
    const double known = std::min(phase_angle, 160.0 * deg);
    return moon_brightness(known) / lommel_seeliger_brightness(known);
}

SpectrumOf<Number> moon_albedo() { return spectrum_of(moon_albedo_at); }

SpectrumOf<Number> moonlight_share(double phase_angle, Length distance) {
    const double share =
        moon_radiance_factor(phase_angle) * lommel_seeliger_brightness(phase_angle) * squared(moon_radius.value / distance.value);
    return moon_albedo().scaled(share);
}

SpectrumOf<Number> earthshine_share(double phase_angle, Length distance) {
    const double from_earth = pi - phase_angle;  // sun - Earth - moon
    const double lambertian = (std::sin(from_earth) + (pi - from_earth) * std::cos(from_earth)) / pi;
    return spectrum_of(earth_albedo_at).scaled(lambertian * squared(earth_radius.value / distance.value));
}

}  // namespace airlight
