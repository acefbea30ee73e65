#include "terrain/tile.h"

#include <cmath>

#include "terrain/ground_cover.h"
#include "terrain/octahedral.h"

namespace airlight {

namespace {

// A feature shows from four squares on: below it, a square's ends do not know what lies between them.
constexpr double squares_of_a_feature = 2.0;

Vec3 normal_of(Vec3 direction, Vec3 slope, double radius_m, double height_m) {
    return glm::normalize(direction - slope * (radius_m / (radius_m + height_m)));
}

std::uint32_t packed(const GroundCover& cover) {
    std::uint32_t bits = 0;
    int shift = 0;
    for (const double share : {cover.steppe, cover.rock, cover.snow}) {
        bits |= static_cast<std::uint32_t>(std::lround(share * 255.0)) << shift;
        shift += 8;
    }
    return bits;
}

TileVertex vertex_at(Vec3 d, double width_m, const HeightField& field) {
    const HeightSample s = field.sample(d, width_m);
    const bool wet = field.sea && s.height_m < 0.0;
    const double height = wet ? 0.0 : s.height_m;
    const Vec3 p = d * (field.radius_m + height);
    const Vec3 normal = wet ? d : normal_of(d, s.slope, field.radius_m, height);
    const Vec3 coarse = wet ? d : normal_of(d, s.coarse_slope, field.radius_m, height);
    const Vec3 broad = normal_of(d, s.broad_slope, field.radius_m, height);
    return {{p.x, p.y, p.z},
            octahedral(normal),
            octahedral(coarse),
            static_cast<float>(s.height_m),
            packed(ground_cover(d, s.height_m, broad))};
}

}  // namespace

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

Tile build_tile(const Node& node, const HeightField& field) {
    Tile tile{node, {}};
    tile.vertices.reserve(patch_vertices);
    const double width_m = squares_of_a_feature * spacing_m(node.level, field.radius_m);
    for (int j = 0; j < patch_side; ++j)
        for (int i = 0; i < patch_side; ++i) tile.vertices.push_back(vertex_at(vertex_direction(node, i, j), width_m, field));
    return tile;
}

}  // namespace airlight
