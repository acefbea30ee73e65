// Where the shadow maps of a view lie: squares across the sun's light, each about a range of distances from the eye
// [Engel2006; Valient2008]. docs/decisions/0013-shadows.md. Uses camera and terrain; knows no GPU.
#pragma once

#include <span>
#include <vector>

#include "camera/camera.h"
#include "terrain/quadtree.h"

namespace airlight::render {

// Axes across the sun's light, of length one and perpendicular. They depend on the sun alone, so that texels stay where they are.
struct LightAxes {
    Vec3 right, up, towards_sun;
};
LightAxes light_axes(Vec3 towards_sun);

// The sun as shadow maps know it: one of those directions that are 1e-4 apart along each axis of the world, the nearest.
Vec3 settled_sun(Vec3 towards_sun);

// A square of texels across the light, and a range of heights along it; from the planet's centre, along the light's axes. What a map of it
// shows depends on it and the light alone.
struct Cascade {
    int level;            // which of the ranges of distances, counted from the nearest
    double from_m, to_m;  // distances from the eye whose points within the camera's view it holds
    Vec3 eye;             // near the camera's, along the axes of the world: its ground is as fine as that eye sees it
    Vec3 centre;          // of the square, and of those points
    double half_width_m;  // of the square
    double texel_m;
    // Along the light: half of the square's width below its centre; no ground before the sun is higher, and objects that are cast from there.
    double lowest_m, highest_m;

    friend bool operator==(const Cascade&, const Cascade&) = default;
};

inline constexpr int most_cascades = 8;

// What holds an object that stands free of the ground.
struct Ball {
    Vec3 centre;  // m from the planet's centre
    double radius_m;
};

// Distances double twice from cascade to cascade, from 64 m on: they are the same whatever the eye does, and so are the sizes of texels.
//   field    of the ground that casts the shadows
//   texels   along a square's side
//   objects  that cast and take shadows as well
// Cascades begin with the nearest in which there may be ground or an object and end with the farthest; at most most_cascades, none if there is none.
// A square stands at one of those places that are an eighth of its width apart, and its eye at one of those a 32nd of its farthest distance
// apart: so that they stay while the camera moves less.
std::vector<Cascade> cascades(const Camera& camera, const LightAxes& axes, const HeightField& field, int texels,
                              std::span<const Ball> objects = {});

// What may shade a point of a cascade, as fine as its map can show: the ground in the column of its square, from its least height on. Patches
// are left coarser than the eye's where what they leave out is half a texel, or, towards the sun from the cascade, a ninth of the sun's
// disk as it is seen from there: finer edges drown in the penumbra. Patches of different levels may leave gaps between them, but no light comes
// through: it would meet the ground where it leaves it. `field` outlives the answer.
PatchChoice casters_of(const Cascade& cascade, const LightAxes& axes, const HeightField& field);

}  // namespace airlight::render
