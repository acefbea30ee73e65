#include "spectrum/colour_temperature.h"

#include <cassert>
#include <cmath>

namespace airlight {

namespace {

// The CIE 1960 diagram, in which colour temperature is defined.
struct Point {
    double u, v;
};
Point cie1960(Xyz colour) {
    const UniformChromaticity c = uniform_chromaticity(colour);
    return {c.u, c.v * 2.0 / 3.0};
}

// Temperatures are searched in reciprocal megakelvin, along which the locus runs at an even pace.
Point locus(double mired) { return cie1960(black_body_colour(1e6 / mired)); }
double distance_to_locus(Point p, double mired) {
    const Point q = locus(mired);
    return std::hypot(p.u - q.u, p.v - q.v);
}

constexpr double hottest = 1e-3;    // mired: 1e9 K, where the colour no longer changes
constexpr double coldest = 1000.0;  // 1000 K

// The sample of the locus nearest to p, ten mired apart.
double nearest_sample(Point p) {
    double best = hottest;
    for (double mired = 10.0; mired <= coldest; mired += 10.0)
        if (distance_to_locus(p, mired) < distance_to_locus(p, best)) best = mired;
    return best;
}

// Golden-section search for the minimum of the distance between two temperatures.
double refined(Point p, double low, double high) {
    constexpr double golden = 0.6180339887498949;
    for (int step = 0; step < 40; ++step) {
        const double a = high - golden * (high - low);
        const double b = low + golden * (high - low);
        (distance_to_locus(p, a) < distance_to_locus(p, b) ? high : low) = distance_to_locus(p, a) < distance_to_locus(p, b) ? b : a;
    }
    return 0.5 * (low + high);
}

}  // namespace

Xyz black_body_colour(double kelvin) {
    assert(kelvin >= 500.0 && kelvin <= 1e9);
    constexpr double second_radiation_constant = 1.4388e7;  // nm K
    // Relative to 560 nm, so that a cold body does not underflow.
    const double reference = std::expm1(second_radiation_constant / (560.0 * kelvin));
    Xyz sum{0.0, 0.0, 0.0};
    for (const ColourMatch& row : cie1931()) {
        const double light =
            std::pow(560.0 / row.wavelength_nm, 5) * reference / std::expm1(second_radiation_constant / (row.wavelength_nm * kelvin));
        sum = sum + light * Xyz{row.x, row.y, row.z};
    }
    return 1.0 / sum.y * sum;
}

std::optional<ColourTemperature> correlated_colour_temperature(Xyz colour) {
    if (!(colour.x + colour.y + colour.z > 0.0)) return std::nullopt;
    const Point p = cie1960(colour);
    const double sample = nearest_sample(p);
    const double mired = refined(p, std::max(hottest, sample - 10.0), std::min(coldest, sample + 10.0));
    const double away = distance_to_locus(p, mired);
    const bool at_an_end = mired < hottest + 1e-3 || mired > coldest - 1e-3;
    if (away > 0.05 || (at_an_end && away > 1e-5)) return std::nullopt;
    return ColourTemperature{1e6 / mired, p.v > locus(mired).v ? away : -away};
}

}  // namespace airlight
