#include "terrain/node_bounds.h"

#include <algorithm>
#include <cmath>

namespace airlight {

namespace {

// Along one axis: the cap's directions have cosines between these, and radii scale them.
Interval along(double cosine, double angle, Interval radii) {
    const double middle = std::acos(std::clamp(cosine, -1.0, 1.0));
    const double high = std::cos(std::max(0.0, middle - angle)), low = std::cos(std::min(pi, middle + angle));
    return {low * (low < 0.0 ? radii.high : radii.low), high * (high < 0.0 ? radii.low : radii.high)};
}

// Whether all of a box is on the outer side of a plane: its p-vertex is.
bool behind(const Box& box, Vec3 inward, Vec3 through) {
    const Vec3 p(inward.x >= 0.0 ? box.high.x : box.low.x, inward.y >= 0.0 ? box.high.y : box.low.y,
                 inward.z >= 0.0 ? box.high.z : box.low.z);
    return glm::dot(inward, p - through) < 0.0;
}

}  // namespace

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

Box box_of(const NodeBounds& b) {
    const Interval x = along(b.cap.centre.x, b.cap.angle, b.radii_m), y = along(b.cap.centre.y, b.cap.angle, b.radii_m),
                   z = along(b.cap.centre.z, b.cap.angle, b.radii_m);
    return {{x.low, y.low, z.low}, {x.high, y.high, z.high}};
}

bool outside(const Box& box, Vec3 eye, const Frustum& frustum) {
    return std::any_of(frustum.begin(), frustum.end(), [&](Vec3 normal) { return behind(box, normal, eye); });
}

bool outside(const Box& box, std::span<const HalfSpace> within) {
    return std::any_of(within.begin(), within.end(), [&](const HalfSpace& h) { return behind(box, h.inward, h.through); });
}

bool below_horizon(const NodeBounds& b, Vec3 eye, double solid_m) {
    const double r = glm::length(eye);
    if (r <= solid_m || b.radii_m.low < solid_m) return false;
    // The eye's horizon on the solid planet, and how far beyond it the highest ground still looks over.
    const double reach = std::acos(solid_m / r) + std::acos(solid_m / b.radii_m.high);
    return angle_between(eye / r, b.cap.centre) - b.cap.angle > reach;
}

}  // namespace airlight
