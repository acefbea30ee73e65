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

// The box along the axes of the world that holds all that is within the bounds.
struct Box {
    Vec3 low, high;
};
Box box_of(const NodeBounds& bounds);

// Whether the box is outside of one of the frustum's planes: the box's corner that lies farthest along the plane's normal, its
// p-vertex, is behind it [Sperlhofer2011, section 4.4.4.2].
bool outside(const Box& box, Vec3 eye, const Frustum& frustum);

// The points p with dot(inward, p - through) >= 0; `inward` is of length one.
struct HalfSpace {
    Vec3 inward, through;
};
// Whether the box lies outside of one of the half-spaces.
bool outside(const Box& box, std::span<const HalfSpace> within);

// Whether the planet, solid up to `solid_m` from its centre, hides all that is within the bounds from an eye.
bool below_horizon(const NodeBounds& bounds, Vec3 eye, double solid_m);

}  // namespace airlight
