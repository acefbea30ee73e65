#include "models/density_spheres.h"

#include <algorithm>
#include <cmath>

namespace airlight {

namespace {

double sphere_m(const f64::ExponentialAir& air, int i) {
    return f64::nishita1993_sphere(air.top, air.air_scale_height, i, DensitySpheres::spheres).value;
}

// The depth from a point outward to the top: trapezoids between the spheres that the ray passes on its way up.
f64::Spectrum rising_depth(const f64::ExponentialAir& air, double h_m, double mu) {
    const f64::Length h = f64::Length::of(h_m);
    f64::AirColumns column{0.0 * f64::m, 0.0 * f64::m};
    f64::AirDensities last = f64::air_densities(air, h);
    f64::Length reached = 0.0 * f64::m;
    for (int i = 0; i < DensitySpheres::spheres; ++i) {
        const f64::Length next = f64::Length::of(sphere_m(air, i));
        if (!(next > h)) continue;
        const f64::Length t = f64::distance_to_top(h, mu, air.bottom, next);
        const f64::AirDensities density = f64::air_densities(air, next);
        column.air += 0.5 * (density.air + last.air) * (t - reached);
        column.aerosol += 0.5 * (density.aerosol + last.aerosol) * (t - reached);
        last = density;
        reached = t;
    }
    return f64::optical_depth(air, column);
}

// Cosine of the zenith angle, at altitude h, of a line that passes the planet's centre at the distance bottom + perigee.
double rising_cosine(const f64::ExponentialAir& air, double h_m, double perigee_m) {
    const double r = air.bottom.value + h_m, c = air.bottom.value + std::min(perigee_m, h_m);
    return std::sqrt(std::max(0.0, (r - c) * (r + c))) / r;
}

}  // namespace

DensitySpheres::DensitySpheres(const TwoConstituents& two) : air_(two.air) {
    for (int j = 0; j < cylinders; ++j) {
        const bool within = j < spheres - 1;
        const double perigee_m =
            within ? air_.bottom.value * (std::sin(0.5 * pi * j / (spheres - 1)) - 1.0) : sphere_m(air_, j - spheres + 1);
        for (int i = 0; i < spheres; ++i) {
            const double h_m = sphere_m(air_, i);
            near_.push_back(rising_depth(air_, h_m, rising_cosine(air_, h_m, perigee_m)));
        }
    }
    for (int j = 0; j < spheres; ++j)
        for (int i = 0; i < spheres; ++i) {
            const double h_m = sphere_m(air_, i), perigee_m = std::min(sphere_m(air_, j), h_m);
            // Down to the waist and out: both halves of the line, less what lies on this side of the point.
            beyond_.push_back(2.0 * rising_depth(air_, perigee_m, 0.0) - rising_depth(air_, h_m, rising_cosine(air_, h_m, perigee_m)));
        }
}

f64::ScatteredLight DensitySpheres::light(const f64::AirRay& ray) const {
    return f64::nishita1993_light(air_, near(), beyond(), spheres, cylinders, ray);
}

f64::Spectrum DensitySpheres::sunlight(f64::Length altitude, double mu_s) const {
    return f64::nishita1993_sunlight(air_, near(), beyond(), spheres, cylinders, altitude, mu_s);
}

}  // namespace airlight
