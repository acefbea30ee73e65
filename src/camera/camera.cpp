#include "camera/camera.h"

#include <cassert>
#include <cmath>

namespace airlight {

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
    return {glm::normalize(half.width * camera.forward + camera.right), glm::normalize(half.width * camera.forward - camera.right),
            glm::normalize(half.height * camera.forward + camera.up), glm::normalize(half.height * camera.forward - camera.up)};
}

Vec3 direction_at(const Camera& camera, double x, double y) {
    const HalfSize half = half_size(camera);
    return glm::normalize(camera.forward + x * half.width * camera.right + y * half.height * camera.up);
}

}  // namespace airlight
