#include "terrain/tile.h"

#include <algorithm>
#include <cmath>

#include "terrain/octahedral.h"

namespace airlight {

namespace {

// A feature shows from four squares on: below it, a square's ends do not know what lies between them.
constexpr double squares_of_a_feature = 2.0;

Vec3 normal_of(Vec3 direction, Vec3 slope, double radius_m, double height_m) {
    return glm::normalize(direction - slope * (radius_m / (radius_m + height_m)));
}

std::uint32_t packed(Vec3 reflectance) {
    std::uint32_t bits = 0;
    for (int c = 0; c < 3; ++c) {
        const double root = std::sqrt(std::clamp(reflectance[c], 0.0, 1.0));
        bits |= static_cast<std::uint32_t>(std::lround(root * 255.0)) << (8 * c);
    }
    return bits;
}

TileVertex vertex_at(Vec3 d, double width_m, const HeightField& field, const GroundColour& colour) {
    const HeightSample s = field.sample(d, width_m);
    const bool wet = field.sea && s.height_m < 0.0;
    const double height = wet ? 0.0 : s.height_m;
    const Vec3 p = d * (field.radius_m + height);
    const Vec3 normal = wet ? d : normal_of(d, s.slope, field.radius_m, height);
    const Vec3 coarse = wet ? d : normal_of(d, s.coarse_slope, field.radius_m, height);
    const Vec3 broad = normal_of(d, s.broad_slope, field.radius_m, height);
    return {{p.x, p.y, p.z}, octahedral(normal), octahedral(coarse), static_cast<float>(s.height_m), packed(colour(d, s.height_m, broad))};
}

double step(double from, double to, double x) {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

}  // namespace

// Reflectances of grass, sand, rock, snow and the sea in sunlight, rounded from their usual ranges.
Vec3 ground_colour(Vec3 direction, double height_m, Vec3 normal) {
    const Vec3 sea(0.02, 0.035, 0.05), sand(0.34, 0.29, 0.20), grass(0.05, 0.085, 0.03), steppe(0.19, 0.17, 0.10), rock(0.15, 0.135, 0.12),
        snow(0.80, 0.82, 0.85);
    if (height_m < 0.0) return sea;
    const double latitude = std::asin(std::clamp(direction.z, -1.0, 1.0)), flatness = glm::dot(direction, normal);
    const double dry = step(12.0 * deg, 22.0 * deg, std::abs(latitude)) * (1.0 - step(28.0 * deg, 38.0 * deg, std::abs(latitude)));
    // Near 5600 m at the equator, 3300 m in the Alps, at the sea beyond 72 degrees.
    const double share_of_72 = std::min(1.0, std::abs(latitude) / (72.0 * deg)), snow_line_m = 5600.0 * (1.0 - share_of_72 * share_of_72);
    Vec3 ground = glm::mix(grass, steppe, std::max(0.85 * dry, step(1200.0, 3500.0, height_m)));
    ground = glm::mix(sand, ground, step(2.0, 30.0, height_m));
    ground = glm::mix(rock, ground, step(0.90, 0.97, flatness));
    return glm::mix(ground, snow, step(snow_line_m - 400.0, snow_line_m + 400.0, height_m) * step(0.80, 0.90, flatness));
}

const std::vector<std::array<std::uint16_t, 3>>& patch_triangles() {
    static const std::vector<std::array<std::uint16_t, 3>> triangles = [] {
        std::vector<std::array<std::uint16_t, 3>> made;
        const auto vertex = [](int i, int j) { return static_cast<std::uint16_t>(j * patch_side + i); };
        for (int j = 0; j < patch_squares; ++j)
            for (int i = 0; i < patch_squares; ++i) {
                made.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
                made.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
            }
        return made;
    }();
    return triangles;
}

Tile build_tile(const Node& node, const HeightField& field, const GroundColour& colour) {
    Tile tile{node, {}};
    tile.vertices.reserve(patch_vertices);
    const double width_m = squares_of_a_feature * spacing_m(node.level, field.radius_m);
    for (int j = 0; j < patch_side; ++j)
        for (int i = 0; i < patch_side; ++i) tile.vertices.push_back(vertex_at(vertex_direction(node, i, j), width_m, field, colour));
    return tile;
}

}  // namespace airlight
