#include "terrain/node_bounds.h"

#include <algorithm>
#include <cmath>

namespace airlight {

NodeBounds bounds_of(const Node& node, const HeightField& field) {
    const Cap cap = cap_of(node);
    Interval heights = field.range(cap);
    if (field.sea) heights = {std::max(heights.low, 0.0), std::max(heights.high, 0.0)};
    return {cap, {field.radius_m + heights.low, field.radius_m + heights.high}};
}

double distance_to(const NodeBounds& b, Vec3 point) {
    const double r = glm::length(point);
    if (r == 0.0) return b.radii_m.low;
    const double gap = std::clamp(angle_between(point / r, b.cap.centre) - b.cap.angle, 0.0, pi);
    const double nearest = std::clamp(r * std::cos(gap), b.radii_m.low, b.radii_m.high);
    const double half_sine = std::sin(0.5 * gap);
    return std::sqrt((r - nearest) * (r - nearest) + 4.0 * r * nearest * half_sine * half_sine);
}

double farthest_along(const NodeBounds& b, Vec3 direction) {
    // The cosine between the direction and the nearest to it of the cap's.
    const double cosine = glm::dot(direction, b.cap.centre), sine = glm::length(glm::cross(direction, b.cap.centre));
    const double cap_cosine = std::cos(b.cap.angle), cap_sine = std::sin(b.cap.angle);
    const double nearest = cosine >= cap_cosine || b.cap.angle >= pi ? 1.0 : cosine * cap_cosine + sine * cap_sine;
    return nearest * (nearest < 0.0 ? b.radii_m.low : b.radii_m.high);
}

bool outside(const NodeBounds& b, Vec3 eye, const Frustum& frustum) {
    return std::any_of(frustum.begin(), frustum.end(), [&](Vec3 inward) { return farthest_along(b, inward) < glm::dot(inward, eye); });
}

bool outside(const NodeBounds& b, std::span<const HalfSpace> within) {
    return std::any_of(within.begin(), within.end(),
                       [&](const HalfSpace& h) { return farthest_along(b, h.inward) < glm::dot(h.inward, h.through); });
}

bool below_horizon(const NodeBounds& b, Vec3 eye, double solid_m) {
    const double r = glm::length(eye);
    if (r <= solid_m || b.radii_m.low < solid_m) return false;
    // The eye's horizon on the solid planet, and how far beyond it the highest ground still looks over.
    const double reach = std::acos(solid_m / r) + std::acos(solid_m / b.radii_m.high);
    return angle_between(eye / r, b.cap.centre) - b.cap.angle > reach;
}

}  // namespace airlight
