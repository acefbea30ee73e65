// The vertices of one patch, computed once in double precision: what the GPU is given, and never changes.
// Uses units.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "terrain/height_field.h"

namespace airlight {

inline constexpr int patch_vertices = patch_side * patch_side;

// As the GPU reads it (src/render/shaders/terrain.vert): ten words of 32 bits.
struct TileVertex {
    std::array<double, 3> position_m;  // from the planet's centre, on the ground or on the sea
    std::uint32_t normal;              // octahedral, of features that this patch's squares can show
    std::uint32_t coarse_normal;       // of those that squares twice as wide can
    float height_m;                    // of the ground, below the sea as well
    std::uint32_t cover;               // GroundCover in 8 bits each, steppe lowest
};
static_assert(sizeof(TileVertex) == 40);

struct Tile {
    Node node;
    std::vector<TileVertex> vertices;  // [j][i], patch_side each way
};

// Positions, heights and covers depend on the vertex alone, not on the node: neighbours share them to the bit.
Tile build_tile(const Node& node, const HeightField& field);

// The triangles of every patch, by the places of their corners in Tile::vertices; anticlockwise seen from outside.
// All squares are cut along the same diagonal, so that squares of one level and of the next are cut alike.
const std::vector<std::array<std::uint16_t, 3>>& patch_triangles();

// The distance between vertices, in the middle of a face.
inline double spacing_m(int level, double radius_m) { return side_m(level, radius_m) / patch_squares; }

}  // namespace airlight
