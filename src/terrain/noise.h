// Gradient noise of three dimensions with its exact derivative [Perlin2002].
// Uses units.
#pragma once

#include <cstdint>

#include "units/vector.h"

namespace airlight {

struct NoiseSample {
    double value;
    Vec3 gradient;
};

// Smooth noise whose features are about one unit wide: 0 at points of the integer lattice, of two continuous derivatives.
// |value| <= noise_bound, |gradient| <= noise_slope_bound. |p| < 2^52.
NoiseSample gradient_noise(Vec3 p, std::uint32_t seed);

// sqrt(3) / 2: the value is a mean of products of gradients of length one and distances to corners, whose squares have a mean
// of at most 1/4 on each axis.
inline constexpr double noise_bound = 0.8660254037844387;
// Not all corners can be at their worst at once: the largest of 4 x 10^7 random points is 2.341 (terrain_test measures some).
inline constexpr double noise_slope_bound = 2.5;

}  // namespace airlight
