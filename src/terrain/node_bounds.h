// What bounds the ground of a node, and what of it an eye may see.
// Uses camera and units.
#pragma once

#include <span>

#include "camera/camera.h"
#include "terrain/height_field.h"

namespace airlight {

// All of a node's ground (of its sea, where there is one) lies within the cap, at radii within `radii_m`.
struct NodeBounds {
    Cap cap;
    Interval radii_m;
};
NodeBounds bounds_of(const Node& node, const HeightField& field);

// Not above the distance from `point` to anything within the bounds; 0 within them.
double distance_to(const NodeBounds& bounds, Vec3 point);

// How far along a direction of length one anything within the bounds reaches, from the planet's centre: where a plane with that normal must
// stand for all of them to be behind it. What the p-vertex is to a box [Sperlhofer2011, section 4.4.4.2]; a box along the axes of the world
// holds several times a small node's ground, most of it above and below.
double farthest_along(const NodeBounds& bounds, Vec3 direction);

// Whether all within the bounds is outside of one of the frustum's planes.
bool outside(const NodeBounds& bounds, Vec3 eye, const Frustum& frustum);

// The points p with dot(inward, p - through) >= 0; `inward` is of length one.
struct HalfSpace {
    Vec3 inward, through;
};
// Whether all within the bounds is outside of one of the half-spaces.
bool outside(const NodeBounds& bounds, std::span<const HalfSpace> within);

// Whether the planet, solid up to `solid_m` from its centre, hides all that is within the bounds from an eye.
bool below_horizon(const NodeBounds& bounds, Vec3 eye, double solid_m);

}  // namespace airlight
