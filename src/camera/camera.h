// An eye without distortion: where it is, where it looks, and which part of space it sees.
// Uses units; knows no GPU.
#pragma once

#include <array>

#include "units/units.h"
#include "units/vector.h"

namespace airlight {

// `right`, `up` and `forward` are of length one and perpendicular; right = forward x up. Pixels are square.
struct Camera {
    Vec3 eye;  // m from the planet's centre
    Vec3 right, up, forward;
    double vertical_field_of_view = 60.0 * deg;  // between the middles of the upper and lower edges, 0 < field < 180 deg
    int width = 1280, height = 720;
    double shift_x = 0.0, shift_y = 0.0;  // pixels that the picture's middle lies to the right of and above what `forward` points at
};

// The camera shifted so that the middles of its pixels are at one of the samples of the pixels: the mean of these pictures has smooth edges.
//   sample    0 <= sample < samples
//   samples   a power of two: each of as many columns of a pixel, and of as many rows, has one sample [KolligKeller2002, the (0,2)-sequence
//             of Sobol's first two dimensions]; the only one of one is the camera itself
Camera sampled(const Camera& camera, int sample, int samples);

// Half of the picture's height and width, on a plane at distance 1.
struct HalfSize {
    double width, height;
};
HalfSize half_size(const Camera& camera);

// A camera at `eye` that looks along `forward`, upright as `up` says; neither needs length one, but they may not be parallel.
Camera look(Vec3 eye, Vec3 forward, Vec3 up);

// A place over a sphere and a direction in its local frame, east-north-up. Angles in radians, heading from north, clockwise.
struct Viewpoint {
    double latitude = 0.0, longitude = 0.0;
    double altitude_m = 2.0;
    double heading = 0.0;
    double pitch = 0.0;  // above the horizontal

    friend bool operator==(const Viewpoint&, const Viewpoint&) = default;
};
Camera look(const Viewpoint& place, double radius_m);

// The unit vector of a latitude and a longitude; its east and north (at the poles, those of the longitude).
Vec3 direction_of(double latitude, double longitude);

// Pixels that an object of 1 m covers at a distance of 1 m in the middle of the picture.
double pixels_per_radian(const Camera& camera);

// The four planes through the eye that bound what it sees, by their normals, of length one, towards the inside: a point p is
// seen if dot(normal, p - eye) >= 0 for all four.
using Frustum = std::array<Vec3, 4>;
Frustum frustum(const Camera& camera);

// The direction, of length one, that is seen at a place of the picture: x to the right, y up, both from -1 to 1.
Vec3 direction_at(const Camera& camera, double x, double y);

}  // namespace airlight
