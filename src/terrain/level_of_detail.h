// How far each level of the quadtree reaches, and how its vertices give way to the coarser level's on the way there.
//
// A vertex that first appears at level l glides, as its distance from the eye grows from glide_begin * reach(l) to reach(l), onto a
// vertex of a coarser level beside it; beyond, the squares around it have become one of the coarser level, exactly. What a vertex
// does depends on its place and the eye alone, and a node gives way to its children only where one of them may be within
// reach: so that patches of any levels have the same edges to the bit, and a change of level changes nothing [Strugar2009 morphs
// alike, by a patch's range]. Uses units.
#pragma once

#include <array>
#include <limits>

#include "terrain/tile.h"

namespace airlight {

// Vertices of a level begin to glide at this share of its reach.
inline constexpr double glide_begin = 0.8;

struct LevelReach {
    int deepest = 0;                                     // levels beyond are never drawn
    std::array<double, deepest_level + 1> reach_m = {};  // reach_m[0] is not used: nothing is coarser than level 0

    // 0 where a vertex stands on its own place, 1 where it has become one of the coarser level.
    double glide(int level, double distance_m) const;
};

struct DetailSettings {
    double pixels_per_radian = 600.0;
    double pixels_of_error = 1.0;    // what height may be wrong by on the picture
    double pixels_of_square = 12.0;  // how wide a square may look
    double finest_square_m = 0.5;    // squares are not made narrower than this
};
// Reaches from the projected error of height that a level leaves out, and from the size that its squares have on the picture.
// Each is more than twice the next one, so that only one level glides at a place, but for the last ones of the list.
LevelReach level_reach(const HeightField& field, const DetailSettings& settings);

// How far squares whose vertices lie `spacing_m` apart may stand beside the ground: features between them, which cannot be more than the
// range of its heights, and the planet's curve.
double error_m(const HeightField& field, double spacing_m, double range_m = std::numeric_limits<double>::infinity());

// Whither a node's vertices glide along each of its axes, 1 or -1: towards the middle of the face, whichever way its coordinates run,
// a rule on which faces on both sides of an edge agree.
struct GlideDirection {
    int x, y;
};
GlideDirection glide_direction(const Node& node);

// The vertex of a patch onto which (i, j) glides, and the level at which it appears; none (i, j itself) for a corner of the patch.
struct Glide {
    int i, j;
    int level;
};
Glide glide_of(const Node& node, int i, int j);

// Where a vertex of a patch stands for an eye. What the vertex shader does, in double precision.
Vec3 glided_position(const Tile& tile, int i, int j, Vec3 eye, const LevelReach& reach);

}  // namespace airlight
