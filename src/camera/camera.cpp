#include "camera/camera.h"

#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>

namespace airlight {

namespace {

// A number below one: the first dimension of Sobol's sequence is radical inversion, by halves of the half before; of the second each
// direction is the one before, added to itself shifted by a digit, without carry.
double sobol(int n, bool second) {
    std::uint32_t digits = 0, direction = std::uint32_t{1} << 31;
    for (auto left = static_cast<std::uint32_t>(n); left > 0; left >>= 1) {
        if (left & 1) digits ^= direction;
        direction = second ? direction ^ (direction >> 1) : direction >> 1;
    }
    return std::ldexp(static_cast<double>(digits), -32);
}

}  // namespace

Camera sampled(const Camera& camera, int sample, int samples) {
    assert(std::has_single_bit(static_cast<unsigned>(samples)) && sample >= 0 && sample < samples);
    const double middle = 0.5 / samples - 0.5;
    Camera shifted = camera;
    shifted.shift_x += sobol(sample, false) + middle;
    shifted.shift_y += sobol(sample, true) + middle;
    return shifted;
}

HalfSize half_size(const Camera& camera) {
    const double height = std::tan(0.5 * camera.vertical_field_of_view);
    return {height * camera.width / camera.height, height};
}

Camera look(Vec3 eye, Vec3 forward, Vec3 up) {
    Camera camera{};
    camera.eye = eye;
    camera.forward = glm::normalize(forward);
    const Vec3 right = glm::cross(camera.forward, up);
    assert(glm::length(right) > 0.0);
    camera.right = glm::normalize(right);
    camera.up = glm::cross(camera.right, camera.forward);
    return camera;
}

Vec3 direction_of(double latitude, double longitude) {
    return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude), std::sin(latitude)};
}

Camera look(const Viewpoint& place, double radius_m) {
    const Vec3 zenith = direction_of(place.latitude, place.longitude);
    const Vec3 east(-std::sin(place.longitude), std::cos(place.longitude), 0.0);
    const Vec3 north = glm::cross(zenith, east);
    const Vec3 level = std::sin(place.heading) * east + std::cos(place.heading) * north;
    const Vec3 forward = std::cos(place.pitch) * level + std::sin(place.pitch) * zenith;
    const Vec3 up = std::cos(place.pitch) * zenith - std::sin(place.pitch) * level;
    return look((radius_m + place.altitude_m) * zenith, forward, up);
}

double pixels_per_radian(const Camera& camera) { return 0.5 * camera.height / half_size(camera).height; }

Frustum frustum(const Camera& camera) {
    const HalfSize half = half_size(camera);
    const double x = 2.0 * camera.shift_x / camera.width, y = 2.0 * camera.shift_y / camera.height;
    return {glm::normalize((1.0 - x) * half.width * camera.forward + camera.right),
            glm::normalize((1.0 + x) * half.width * camera.forward - camera.right),
            glm::normalize((1.0 - y) * half.height * camera.forward + camera.up),
            glm::normalize((1.0 + y) * half.height * camera.forward - camera.up)};
}

Vec3 direction_at(const Camera& camera, double x, double y) {
    const HalfSize half = half_size(camera);
    const double across = x + 2.0 * camera.shift_x / camera.width, up = y + 2.0 * camera.shift_y / camera.height;
    return glm::normalize(camera.forward + across * half.width * camera.right + up * half.height * camera.up);
}

}  // namespace airlight
