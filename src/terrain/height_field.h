// How high the ground is in each direction from a planet's centre, with its slope and with bounds that hold.
// Uses units.
#pragma once

#include <functional>

#include "terrain/cube_sphere.h"

namespace airlight {

struct Interval {
    double low = 0.0, high = 0.0;
};

// A slope is the gradient along the sphere of radius_m, in metres of height a metre, as a vector of space.
struct HeightSample {
    double height_m;
    Vec3 slope;         // of the features that are wider than the asked width
    Vec3 coarse_slope;  // of those wider than twice that
    Vec3 broad_slope;   // of those wider than broad_width_m, whatever was asked
};
inline constexpr double broad_width_m = 100.0;

// A ground. Its functions may be called from any thread.
struct HeightField {
    double radius_m;  // of the sphere above which heights count

    // The height in `direction`, of all features. Features narrower than `width_m` have no part in the slope, those up to twice
    // as wide fade in: so that a vertex is lit by what lies between it and the next ones.
    std::function<HeightSample(Vec3 direction, double width_m)> sample;

    // No height within the cap is outside of it.
    std::function<Interval(const Cap& cap)> range;

    // About how much of height lies in features that vertices `spacing_m` apart miss and those half as far apart do not.
    std::function<double(double spacing_m)> detail;

    Interval whole;    // of the planet
    bool sea = false;  // what lies below 0 m is under water
};

// The weight of features of a wavelength in the slope: 0 up to `width_m`, 1 from twice of it.
double slope_weight(double wavelength_m, double width_m);

}  // namespace airlight
