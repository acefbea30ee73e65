// An eye that flies: from an orbit to the grass without a seam, and never into the ground.
// Uses camera, scene and terrain; knows no window.
#pragma once

#include "scene/scene.h"

namespace airlight::viewer {

// Where the pilot pushes, each from -1 to 1. `forward` is along the view, `up` away from the planet.
struct Steering {
    double forward = 0.0, right = 0.0, up = 0.0;
};

// No eye comes nearer to the ground or the sea: a person's height.
inline constexpr double lowest_eye_m = 1.7;
// Nor flies farther from 0 m.
inline constexpr double highest_eye_m = 1e9;

// The height of the eye above the ground, or the sea, in metres.
double height_m(const Viewpoint& eye, const HeightField& ground);

// The speed at a height above the ground, in m/s: it grows with it, so that every part of the way from space takes as long.
//   per_s  the share of the height that is flown in a second, above 0
double speed_m_s(double height_above_ground_m, double per_s);

// The eye after `seconds` >= 0. It keeps its pitch above the horizon of each place, and the great circle that it looks along.
// What is flown does not depend, but for a thousandth, on how the time is cut into frames.
Viewpoint flown(Viewpoint eye, const Steering& steering, double per_s, double seconds, const HeightField& ground);

// The eye turned to the right and up by angles in radians; it looks at most straight up or down.
Viewpoint turned(Viewpoint eye, double right, double up);

// The eye lifted out of the ground, if it is within lowest_eye_m of it.
Viewpoint above_ground(Viewpoint eye, const HeightField& ground);

}  // namespace airlight::viewer
