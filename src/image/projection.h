// Which direction a pixel looks in, and which pixel sees a direction.
// Directions are unit vectors x east, y north, z up (units/vector.h); azimuth is from north, clockwise.
// Uses units; knows nothing of light.
#pragma once

#include <optional>
#include <variant>

#include "core/result.h"
#include "units/units.h"
#include "units/vector.h"

namespace airlight {

// A place in an image, in pixels: (0, 0) is the upper left corner, (0.5, 0.5) the centre of the first pixel.
struct ImagePoint {
    double x, y;
};

// The whole sphere, equirectangular: the zenith along the top row, the nadir along the bottom row; to the right, azimuth
// grows, as it does when one turns right.
struct FullSphere {
    int width, height;
    double centre_azimuth = 180.0 * deg;  // in the middle of the image; its left and right edges meet opposite
};

// Straight up in the middle, inside the largest circle that fits; nothing outside of it. Seen from below, as lying on
// one's back: with north at the top, east is on the left.
struct Fisheye {
    enum class Law { equidistant, equal_area };  // radius ~ zenith angle; radius ~ sin(zenith angle / 2), equal solid angles
    int width, height;
    Law law = Law::equidistant;
    double field = 180.0 * deg;  // across the whole circle, 0 < field <= 360 deg
    double top_azimuth = 0.0;    // of what is at the top
};

// A camera without distortion.
struct Perspective {
    int width, height;
    double heading = 0.0;                        // azimuth of the optical axis
    double pitch = 0.0;                          // its elevation above the horizon
    double roll = 0.0;                           // the camera turned clockwise, seen from behind it
    double vertical_field_of_view = 60.0 * deg;  // 0 < field < 180 deg; pixels are square
};

// Six square faces one below the other, +x (east), -x, +y (north), -y, +z (up), -z, each in OpenGL's orientation: face i,
// its rows in order, goes to GL_TEXTURE_CUBE_MAP_POSITIVE_X + i, and is read with the east-north-up direction itself.
struct CubeMap {
    int side;  // the image has side x 6 side pixels
};

using Projection = std::variant<FullSphere, Fisheye, Perspective, CubeMap>;

struct ImageSize {
    int width, height;
};
ImageSize image_size(const Projection& projection);

// Fails, saying what, if a size is out of the bounds of images, an angle is not finite or a field is out of range.
Result<Done> check(const Projection& projection);

// The direction seen at a point of the image; none outside of the image or of the fisheye's circle.
std::optional<Vec3> direction(const Projection& projection, ImagePoint point);

// The point that sees a direction of length one: the inverse of direction(); none if the image does not show it.
std::optional<ImagePoint> image_point(const Projection& projection, Vec3 direction);

// Solid angle of a pixel in sr: exact but for the fisheye, where it is the value at the centre times the pixel's area;
// 0 for pixels whose centre sees nothing.
double pixel_solid_angle(const Projection& projection, int column, int row);

// Unit vector of an azimuth and a zenith angle, in radians, and back: azimuth in [0, 2 pi).
struct SkyAngles {
    double azimuth, zenith;
};
Vec3 sky_direction(SkyAngles angles);
SkyAngles sky_angles(Vec3 direction);

}  // namespace airlight
