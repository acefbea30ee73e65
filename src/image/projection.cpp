#include "image/projection.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <initializer_list>

#include "image/image.h"

namespace airlight {

namespace {

// Equal to the angle but for whole turns, in [0, 2 pi).
double turned(double angle) {
    const double rest = angle - 2.0 * pi * std::floor(angle / (2.0 * pi));
    return rest < 2.0 * pi ? rest : 0.0;  // -1e-17 rounds to a whole turn
}

bool inside(ImageSize size, ImagePoint p) { return p.x >= 0.0 && p.y >= 0.0 && p.x <= size.width && p.y <= size.height; }

// Solid angle, seen from the origin, of the rectangle from (0, 0) to (x, y) on the plane z = 1.
double corner_solid_angle(double x, double y) { return std::atan2(x * y, std::sqrt(x * x + y * y + 1.0)); }
double rectangle_solid_angle(double x0, double x1, double y0, double y1) {
    return std::abs(corner_solid_angle(x1, y1) - corner_solid_angle(x0, y1) - corner_solid_angle(x1, y0) + corner_solid_angle(x0, y0));
}

// Full sphere.
ImageSize size_of(const FullSphere& p) { return {p.width, p.height}; }
std::optional<Vec3> direction_of(const FullSphere& p, ImagePoint at) {
    return sky_direction({p.centre_azimuth + (at.x / p.width - 0.5) * 2.0 * pi, at.y / p.height * pi});
}
std::optional<ImagePoint> point_of(const FullSphere& p, Vec3 d) {
    const SkyAngles angles = sky_angles(d);
    return ImagePoint{turned(angles.azimuth - p.centre_azimuth + pi) / (2.0 * pi) * p.width, angles.zenith / pi * p.height};
}
double solid_angle_of(const FullSphere& p, int, int row) {
    // cos a - cos b as a product, so that rows at the poles lose no digits.
    const double middle = (row + 0.5) / p.height * pi, half = 0.5 / p.height * pi;
    return 2.0 * pi / p.width * 2.0 * std::sin(middle) * std::sin(half);
}

// Fisheye: distance from the middle as a share of the circle's radius, and back.
double share_of_radius(const Fisheye& p, double zenith) {
    return p.law == Fisheye::Law::equidistant ? zenith / (0.5 * p.field) : std::sin(0.5 * zenith) / std::sin(0.25 * p.field);
}
double zenith_at(const Fisheye& p, double share) {
    return p.law == Fisheye::Law::equidistant ? share * 0.5 * p.field : 2.0 * std::asin(std::min(1.0, share * std::sin(0.25 * p.field)));
}
double circle_radius(const Fisheye& p) { return 0.5 * std::min(p.width, p.height); }

ImageSize size_of(const Fisheye& p) { return {p.width, p.height}; }
std::optional<Vec3> direction_of(const Fisheye& p, ImagePoint at) {
    const double right = at.x - 0.5 * p.width, up = 0.5 * p.height - at.y;
    const double share = std::hypot(right, up) / circle_radius(p);
    if (share > 1.0) return std::nullopt;
    return sky_direction({p.top_azimuth + std::atan2(-right, up), zenith_at(p, share)});
}
std::optional<ImagePoint> point_of(const Fisheye& p, Vec3 d) {
    const SkyAngles angles = sky_angles(d);
    const double share = share_of_radius(p, angles.zenith);
    if (share > 1.0) return std::nullopt;
    const double radius = share * circle_radius(p), around = angles.azimuth - p.top_azimuth;
    return ImagePoint{0.5 * p.width - radius * std::sin(around), 0.5 * p.height - radius * std::cos(around)};
}
double solid_angle_of(const Fisheye& p, int column, int row) {
    const double share = std::hypot(column + 0.5 - 0.5 * p.width, row + 0.5 - 0.5 * p.height) / circle_radius(p);
    if (share > 1.0) return 0.0;
    const double pixel = 1.0 / circle_radius(p);
    if (p.law == Fisheye::Law::equal_area) return std::pow(2.0 * std::sin(0.25 * p.field) * pixel, 2);
    const double zenith = zenith_at(p, share);
    return std::pow(0.5 * p.field * pixel, 2) * (zenith > 0.0 ? std::sin(zenith) / zenith : 1.0);
}

// Perspective: the camera's axes, and half a pixel's size on the plane at distance one.
struct CameraAxes {
    Vec3 right, up, forward;
};
CameraAxes camera_axes(const Perspective& p) {
    const Vec3 forward = sky_direction({p.heading, 0.5 * pi - p.pitch});
    const Vec3 level(std::cos(p.heading), -std::sin(p.heading), 0.0);
    const Vec3 upright = glm::cross(level, forward);
    const double c = std::cos(p.roll), s = std::sin(p.roll);
    return {c * level - s * upright, s * level + c * upright, forward};
}
double pixel_size(const Perspective& p) { return 2.0 * std::tan(0.5 * p.vertical_field_of_view) / p.height; }

ImageSize size_of(const Perspective& p) { return {p.width, p.height}; }
std::optional<Vec3> direction_of(const Perspective& p, ImagePoint at) {
    const CameraAxes axes = camera_axes(p);
    const double size = pixel_size(p);
    return glm::normalize(axes.forward + (at.x - 0.5 * p.width) * size * axes.right + (0.5 * p.height - at.y) * size * axes.up);
}
std::optional<ImagePoint> point_of(const Perspective& p, Vec3 d) {
    const CameraAxes axes = camera_axes(p);
    const double depth = glm::dot(d, axes.forward);
    if (depth <= 0.0) return std::nullopt;
    const double scale = 1.0 / (depth * pixel_size(p));
    const ImagePoint point{0.5 * p.width + glm::dot(d, axes.right) * scale, 0.5 * p.height - glm::dot(d, axes.up) * scale};
    if (!inside(size_of(p), point)) return std::nullopt;
    return point;
}
double solid_angle_of(const Perspective& p, int column, int row) {
    const double size = pixel_size(p), x = (column - 0.5 * p.width) * size, y = (row - 0.5 * p.height) * size;
    return rectangle_solid_angle(x, x + size, y, y + size);
}

// Cube map: each face's middle, and where its columns and rows go (OpenGL 4.5 core specification, table 8.19).
struct Face {
    Vec3 middle, right, down;
};
const std::array<Face, 6>& faces() {
    static const std::array<Face, 6> table{{{{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
                                            {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
                                            {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
                                            {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
                                            {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},
                                            {{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}}}};
    return table;
}

ImageSize size_of(const CubeMap& p) { return {p.side, 6 * p.side}; }
std::optional<Vec3> direction_of(const CubeMap& p, ImagePoint at) {
    const int index = std::min(5, static_cast<int>(at.y / p.side));
    const Face& face = faces()[static_cast<std::size_t>(index)];
    const double s = 2.0 * at.x / p.side - 1.0, t = 2.0 * (at.y / p.side - index) - 1.0;
    return glm::normalize(face.middle + s * face.right + t * face.down);
}
std::optional<ImagePoint> point_of(const CubeMap& p, Vec3 d) {
    int nearest = 0;
    for (int i = 1; i < 6; ++i)
        if (glm::dot(d, faces()[static_cast<std::size_t>(i)].middle) > glm::dot(d, faces()[static_cast<std::size_t>(nearest)].middle))
            nearest = i;
    const Face& face = faces()[static_cast<std::size_t>(nearest)];
    const double depth = glm::dot(d, face.middle);
    return ImagePoint{0.5 * (glm::dot(d, face.right) / depth + 1.0) * p.side,
                      (nearest + 0.5 * (glm::dot(d, face.down) / depth + 1.0)) * p.side};
}
double solid_angle_of(const CubeMap& p, int column, int row) {
    const double size = 2.0 / p.side, x = column * size - 1.0, y = (row % p.side) * size - 1.0;
    return rectangle_solid_angle(x, x + size, y, y + size);
}

bool finite(std::initializer_list<double> angles) {
    return std::all_of(angles.begin(), angles.end(), [](double a) { return std::isfinite(a); });
}
bool angles_are_finite(const FullSphere& p) { return finite({p.centre_azimuth}); }
bool angles_are_finite(const Fisheye& p) { return finite({p.field, p.top_azimuth}); }
bool angles_are_finite(const Perspective& p) { return finite({p.heading, p.pitch, p.roll, p.vertical_field_of_view}); }
bool angles_are_finite(const CubeMap&) { return true; }

}  // namespace

ImageSize image_size(const Projection& projection) {
    return std::visit([](const auto& p) { return size_of(p); }, projection);
}

Result<Done> check(const Projection& projection) {
    if (const auto* cube = std::get_if<CubeMap>(&projection); cube && (cube->side < 1 || cube->side > Image::max_side / 6))
        return Error{
            "", fmt::format("a cube map with faces of {} pixels is out of range: they have 1 to {}", cube->side, Image::max_side / 6), ""};
    const ImageSize size = image_size(projection);
    if (const Result<Done> in_bounds = Image::check_size(size.width, size.height, 1); !in_bounds) return in_bounds.error();
    if (!std::visit([](const auto& p) { return angles_are_finite(p); }, projection))
        return Error{"", "an angle of the projection is not finite", ""};
    if (const auto* eye = std::get_if<Fisheye>(&projection); eye && !(eye->field > 0.0 && eye->field <= 2.0 * pi))
        return Error{"", fmt::format("a fisheye's field of {} deg is out of range: it is above 0 and at most 360 deg", eye->field / deg),
                     ""};
    if (const auto* camera = std::get_if<Perspective>(&projection);
        camera && !(camera->vertical_field_of_view > 0.0 && camera->vertical_field_of_view < pi))
        return Error{"",
                     fmt::format("a vertical field of view of {} deg is out of range: it is above 0 and below 180 deg",
                                 camera->vertical_field_of_view / deg),
                     "A fisheye or the full sphere sees more."};
    return Done{};
}

std::optional<Vec3> direction(const Projection& projection, ImagePoint point) {
    if (!inside(image_size(projection), point)) return std::nullopt;
    return std::visit([&](const auto& p) { return direction_of(p, point); }, projection);
}

std::optional<ImagePoint> image_point(const Projection& projection, Vec3 d) {
    assert(std::abs(glm::dot(d, d) - 1.0) < 1e-6);
    return std::visit([&](const auto& p) { return point_of(p, d); }, projection);
}

double pixel_solid_angle(const Projection& projection, int column, int row) {
    return std::visit([&](const auto& p) { return solid_angle_of(p, column, row); }, projection);
}

Vec3 sky_direction(SkyAngles angles) {
    const double s = std::sin(angles.zenith);
    return {s * std::sin(angles.azimuth), s * std::cos(angles.azimuth), std::cos(angles.zenith)};
}

SkyAngles sky_angles(Vec3 d) { return {turned(std::atan2(d.x, d.y)), std::atan2(std::hypot(d.x, d.y), d.z)}; }

}  // namespace airlight
