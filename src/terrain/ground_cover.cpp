#include "terrain/ground_cover.h"

#include <algorithm>
#include <cmath>

#include "units/units.h"

namespace airlight {

namespace {

double step(double from, double to, double x) {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

}  // namespace

GroundCover ground_cover(Vec3 direction, double height_m, Vec3 normal) {
    const double latitude = std::asin(std::clamp(direction.z, -1.0, 1.0)), flatness = glm::dot(direction, normal);
    const double dry = step(12.0 * deg, 22.0 * deg, std::abs(latitude)) * (1.0 - step(28.0 * deg, 38.0 * deg, std::abs(latitude)));
    // Near 5600 m at the equator, 3300 m in the Alps, at the sea beyond 72 degrees.
    const double share_of_72 = std::min(1.0, std::abs(latitude) / (72.0 * deg)), snow_line_m = 5600.0 * (1.0 - share_of_72 * share_of_72);
    return {.steppe = std::max(0.85 * dry, step(1200.0, 3500.0, height_m)),
            .rock = 1.0 - step(0.90, 0.97, flatness),
            .snow = step(snow_line_m - 400.0, snow_line_m + 400.0, height_m) * step(0.80, 0.90, flatness)};
}

// Reflectances in sunlight, rounded from their usual ranges; what they vary by is by eye.
const std::array<GroundMaterial, ground_kinds>& ground_materials() {
    static const std::array<GroundMaterial, ground_kinds> materials = {{
        {.reflectance = {0.05, 0.085, 0.03}, .contrast = 0.20, .tint = {0.07, 0.0, 0.03}, .relief = 0.16},
        {.reflectance = {0.19, 0.17, 0.10}, .contrast = 0.16, .tint = {-0.05, 0.02, -0.04}, .relief = 0.12},
        {.reflectance = {0.34, 0.29, 0.20}, .contrast = 0.06, .tint = {0.02, 0.0, -0.03}, .relief = 0.06},
        {.reflectance = {0.15, 0.135, 0.12}, .contrast = 0.22, .tint = {0.06, 0.02, -0.02}, .relief = 0.25},
        {.reflectance = {0.80, 0.82, 0.85}, .contrast = 0.02, .tint = {0.0, 0.0, 0.0}, .relief = 0.07},
        {.reflectance = {0.02, 0.035, 0.05}, .contrast = 0.0, .tint = {0.0, 0.0, 0.0}, .relief = 0.0},
    }};
    return materials;
}

}  // namespace airlight
