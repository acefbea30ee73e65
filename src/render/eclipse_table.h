// What the moon covers of the sun, as shaders read it (src/render/shaders/air_view.glsl): over the distance of the disks' centres and the ratio
// of their radii. Uses celestial; knows no GPU.
#pragma once

#include <vector>

#include "render/heavens.h"

namespace airlight::render {

// Columns: distances of 0 to the inner contact, even, in the first quarter; from there to the outer one even in their square root, as near
// the inner one light grows by a power of it. Rows: ratios of the moon's radius to the sun's, even.
struct EclipseTable {
    static constexpr int columns = 257, rows = 17;
    float first_ratio, last_ratio;
    std::vector<float> texels;  // [rows][columns] of covered_sun(): disk, first, second, 0
};

// For points within `reach_m` of the planet's centre, which is `centre_m` from the eye.
EclipseTable eclipse_table(const Eclipse& eclipse, Vec3 centre_m, double reach_m);

}  // namespace airlight::render
