// What covers the ground: grass, rock and snow by height, slope and latitude. Sand lies along shores, in strips that are narrower than the
// ground's squares: src/render/shaders/terrain.frag finds them pixel by pixel.
// Uses units.
#pragma once

#include <array>

#include "units/vector.h"

namespace airlight {

// Each from 0 to 1: how far what lies before it has given way to it. Grass comes first, which all of them cover in this order.
struct GroundCover {
    double steppe, rock, snow;
};

// At a height above the sea, in metres; `normal` is that of the ground's broad features.
GroundCover ground_cover(Vec3 direction, double height_m, Vec3 normal);

// What is under one's feet.
struct GroundMaterial {
    Vec3 reflectance;  // of red, green and blue light, in all directions alike, in the mean
    double contrast;   // root of the mean square of what it varies by from place to place, as a share of it
    Vec3 tint;         // the same in each colour apart, and of it the sign
    double relief;     // root of the mean square of its slope along any line, of what is smaller than the ground's own squares
};

// Grass, steppe, sand, rock, snow, and the sea.
inline constexpr int ground_kinds = 6;
const std::array<GroundMaterial, ground_kinds>& ground_materials();

}  // namespace airlight
