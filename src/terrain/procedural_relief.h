// A ground made of octaves of gradient noise: continents, and mountains that are rougher where the land is high
// [Perlin2002; Musgrave1989; Sperlhofer2011, section 4.4.2.3, whose two octaves become two dozen].
// Uses units.
#pragma once

#include <cstdint>

#include "terrain/height_field.h"

namespace airlight {

// An octave of wavelength w has the amplitude amplitude_m (w / wavelength_m)^smoothness; each is half as wide as the one before.
struct Octaves {
    double wavelength_m;  // of the widest
    double amplitude_m;   // of the widest
    double smoothness;    // 0 < smoothness < 1.5: below 1, the narrower the steeper
    double narrowest_m;   // the last octave is at least so wide
    std::uint32_t seed;
};

struct ProceduralRelief {
    double radius_m = 6'360'000.0;
    Octaves continents = {4'000'000.0, 3500.0, 1.0, 150'000.0, 1};
    Octaves mountains = {120'000.0, 4500.0, 0.85, 0.5, 2};
    // Mountains stand at their full amplitude where the continents are higher than this; at this share of it at the sea and below.
    double full_at_m = 1500.0;
    double least_share = 0.05;
    double mean_m = -200.0;
    bool sea = true;
};

// Fine detail below a resolution alone: octaves of noise around 0 m, for what a raster does not hold.
struct NoiseRelief {
    double height_m;
    Vec3 slope, coarse_slope, broad_slope;
};
NoiseRelief noise_relief(const Octaves& octaves, double radius_m, Vec3 direction, double width_m);
// Bounds of noise_relief().height_m within a cap: what its middle has, and what the octaves can change on the way.
Interval noise_relief_range(const Octaves& octaves, double radius_m, const Cap& cap);
double largest_noise_relief(const Octaves& octaves);
// The amplitude of the octaves between spacing_m and twice of it.
double noise_relief_detail(const Octaves& octaves, double spacing_m);

HeightField procedural_height(const ProceduralRelief& relief);

}  // namespace airlight
