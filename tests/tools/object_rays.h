// Where a ray passes through a sphere, a box or a cylinder, by the textbook and in double.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "objects/object.h"

namespace airlight::test {

inline Vec3 along_axes(const Object& o, Vec3 v) { return {glm::dot(v, o.right), glm::dot(v, o.forward), glm::dot(v, o.up)}; }

// Distances from the ray's beginning, which may be below 0, and the outward normal where it enters.
struct RayInObject {
    double enters_m, leaves_m;
    Vec3 normal;
};

// None if the line of the ray, whose direction is of length one, does not meet it.
inline std::optional<RayInObject> ray_in(const Object& o, Vec3 from, Vec3 direction) {
    const Vec3 e = along_axes(o, from - o.centre), d = along_axes(o, direction);
    RayInObject way{-1e300, 1e300, Vec3(0.0)};
    const auto narrow = [&](double enters, double leaves, Vec3 outward) {
        if (enters > way.enters_m) way.enters_m = enters, way.normal = outward;
        way.leaves_m = std::min(way.leaves_m, leaves);
    };
    const auto faces = [&](int axis) {
        const double a = (-o.half_size_m[axis] - e[axis]) / d[axis], b = (o.half_size_m[axis] - e[axis]) / d[axis];
        Vec3 outward(0.0);
        outward[axis] = d[axis] > 0.0 ? -1.0 : 1.0;
        narrow(std::min(a, b), std::max(a, b), outward);
    };
    const auto round = [&](Vec3 counts) {
        const Vec3 p = e * counts, v = d * counts;
        const double a = glm::dot(v, v), b = glm::dot(p, v), c = glm::dot(p, p) - o.half_size_m.x * o.half_size_m.x;
        if (b * b < a * c) return narrow(1.0, 0.0, Vec3(0.0));
        const double root = std::sqrt(b * b - a * c), enters = (-b - root) / a;
        narrow(enters, (-b + root) / a, (p + enters * v) / o.half_size_m.x);
    };
    if (o.shape == Shape::box) faces(0), faces(1), faces(2);
    if (o.shape == Shape::sphere) round(Vec3(1.0));
    if (o.shape == Shape::cylinder) round(Vec3(1.0, 1.0, 0.0)), faces(2);
    if (way.enters_m >= way.leaves_m) return {};
    way.normal = way.normal.x * o.right + way.normal.y * o.forward + way.normal.z * o.up;
    return way;
}

}  // namespace airlight::test
