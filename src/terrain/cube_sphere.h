// A sphere as the six faces of a cube, each a quadtree [Sperlhofer2011, section 4.4.2.1].
// What is shared by neighbours is computed from the same bits, so that it is the same to the bit on both faces of an edge.
// Uses units.
#pragma once

#include <array>
#include <compare>
#include <cstdint>

#include "units/units.h"
#include "units/vector.h"

namespace airlight {

inline constexpr int cube_faces = 6;
inline constexpr int deepest_level = 24;
// Squares along a side of a patch, the same at each level: a power of two.
inline constexpr int patch_squares = 16;
inline constexpr int patch_side = patch_squares + 1;  // vertices

// A square of a face: the face is one at level 0 and 2^level x 2^level at the others; x and y count from the face's corner.
struct Node {
    int face = 0, level = 0;
    std::uint32_t x = 0, y = 0;
    friend auto operator<=>(const Node&, const Node&) = default;
};
std::array<Node, 4> children(const Node& node);
Node parent(const Node& node);  // of a node above level 0

// The direction, of length one, of a point of a face: u and v from -1 to 1, (0, 0) its middle. Seen from outside, v is
// anticlockwise of u.
Vec3 direction(int face, double u, double v);

// A vertex of a node's patch: 0 <= i, j <= patch_squares; (0, 0) at the node's corner of least x and y.
Vec3 vertex_direction(const Node& node, int i, int j);

// The node of a level that holds a direction; on an edge, one of them.
Node node_of(Vec3 direction, int level);

// The directions within `angle` of `centre`.
struct Cap {
    Vec3 centre;
    double angle;
};
// The smallest cap about a node's middle that holds all of it: sides are great circles, so a corner is its farthest point.
Cap cap_of(const Node& node);

// Length of a node's side in the middle of a face, on a sphere of `radius_m`; nowhere is it longer by more than 1 %.
double side_m(int level, double radius_m);

// The angle between two directions of length one, exact for small ones as well.
double angle_between(Vec3 a, Vec3 b);

}  // namespace airlight
