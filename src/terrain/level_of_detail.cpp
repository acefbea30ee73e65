#include "terrain/level_of_detail.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace airlight {

namespace {

// Of a node of `level`, corner to corner, with what the map of the cube and heights add.
double diameter_m(int level, const HeightField& field) {
    return 1.5 * side_m(level, field.radius_m) + std::min(field.whole.high - field.whole.low, field.detail(side_m(level, field.radius_m)));
}

Vec3 position(const Tile& tile, int i, int j) {
    const auto& p = tile.vertices[static_cast<std::size_t>(j * patch_side + i)].position_m;
    return {p[0], p[1], p[2]};
}

}  // namespace

double LevelReach::glide(int level, double distance_m) const {
    if (level == 0) return 0.0;
    const double reach = reach_m[static_cast<std::size_t>(level)];
    return std::clamp((distance_m - glide_begin * reach) / (reach - glide_begin * reach), 0.0, 1.0);
}

double error_m(const HeightField& field, double spacing_m, double range_m) {
    return std::min(field.detail(spacing_m), range_m) + spacing_m * spacing_m / (8.0 * field.radius_m);
}

LevelReach level_reach(const HeightField& field, const DetailSettings& s) {
    LevelReach reach;
    while (reach.deepest < deepest_level && spacing_m(reach.deepest + 1, field.radius_m) >= s.finest_square_m) ++reach.deepest;
    double beyond = 0.0;
    for (int level = reach.deepest; level > 0; --level) {
        const double coarse = spacing_m(level - 1, field.radius_m);
        const double by_error = error_m(field, coarse) * s.pixels_per_radian / s.pixels_of_error;
        const double by_size = coarse * s.pixels_per_radian / s.pixels_of_square;
        // What lies within a node of this level must not glide at the level before it, or normals would differ at edges.
        beyond = std::max({by_error, by_size, (beyond + diameter_m(level, field)) / glide_begin});
        reach.reach_m[static_cast<std::size_t>(level)] = beyond;
    }
    return reach;
}

GlideDirection glide_direction(const Node& node) {
    const std::uint32_t half = node.level > 0 ? std::uint32_t{1} << (node.level - 1) : 0;
    return {node.x < half ? 1 : -1, node.y < half ? 1 : -1};
}

Glide glide_of(const Node& node, int i, int j) {
    const int step = std::countr_zero(static_cast<unsigned>(i | j | patch_squares));
    if (step >= std::countr_zero(static_cast<unsigned>(patch_squares))) return {i, j, 0};
    const GlideDirection towards = glide_direction(node);
    const int bit = 1 << step;
    return {i & bit ? i + towards.x * bit : i, j & bit ? j + towards.y * bit : j, std::max(0, node.level - step)};
}

Vec3 glided_position(const Tile& tile, int i, int j, Vec3 eye, const LevelReach& reach) {
    Vec3 sum(0.0);
    double left = 1.0;
    while (true) {
        const Vec3 p = position(tile, i, j);
        const Glide next = glide_of(tile.node, i, j);
        const double share = reach.glide(next.level, glm::length(p - eye));
        sum += left * (1.0 - share) * p;
        left *= share;
        if (left == 0.0) return sum;
        i = next.i, j = next.j;
    }
}

}  // namespace airlight
