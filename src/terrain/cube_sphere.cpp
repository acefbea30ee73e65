#include "terrain/cube_sphere.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace airlight {

namespace {

// Spreads the vertices over the sphere nearly as an angle would (tan(t pi / 4)), but is odd and exact at 0 and 1 in any arithmetic.
constexpr double stretch = 1.0 - pi / 4.0;
double spread(double t) { return t * (1.0 - stretch * (1.0 - t * t)); }

double gathered(double spread_t) {
    double t = spread_t;
    for (int i = 0; i < 6; ++i) t -= (spread(t) - spread_t) / (1.0 - stretch + 3.0 * stretch * t * t);
    return t;
}

Vec3 on_cube(int face, double a, double b) {
    switch (face) {
        case 0:
            return {1.0, a, b};
        case 1:
            return {-1.0, b, a};
        case 2:
            return {b, 1.0, a};
        case 3:
            return {a, -1.0, b};
        case 4:
            return {a, b, 1.0};
        default:
            return {b, a, -1.0};
    }
}

// The same sum in the same order for whichever face asks.
Vec3 unit(Vec3 p) {
    const double length = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
    return {p.x / length, p.y / length, p.z / length};
}

struct FacePoint {
    int face;
    double a, b;
};

FacePoint face_point(Vec3 d) {
    const double x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
    if (x >= y && x >= z) return d.x > 0.0 ? FacePoint{0, d.y / x, d.z / x} : FacePoint{1, d.z / x, d.y / x};
    if (y >= z) return d.y > 0.0 ? FacePoint{2, d.z / y, d.x / y} : FacePoint{3, d.x / y, d.z / y};
    return d.z > 0.0 ? FacePoint{4, d.x / z, d.y / z} : FacePoint{5, d.y / z, d.x / z};
}

std::uint32_t cell(double t, int level) {
    const double cells = std::ldexp(1.0, level);
    return static_cast<std::uint32_t>(std::clamp(std::floor((t + 1.0) * 0.5 * cells), 0.0, cells - 1.0));
}

}  // namespace

std::array<Node, 4> children(const Node& n) {
    const Node first{n.face, n.level + 1, 2 * n.x, 2 * n.y};
    return {first,
            {n.face, n.level + 1, first.x + 1, first.y},
            {n.face, n.level + 1, first.x, first.y + 1},
            {n.face, n.level + 1, first.x + 1, first.y + 1}};
}

Node parent(const Node& n) {
    assert(n.level > 0);
    return {n.face, n.level - 1, n.x / 2, n.y / 2};
}

Vec3 direction(int face, double u, double v) { return unit(on_cube(face, spread(u), spread(v))); }

Vec3 vertex_direction(const Node& node, int i, int j) {
    // Dyadic fractions: exact.
    const double scale = std::ldexp(2.0 / patch_squares, -node.level);
    return direction(node.face, (static_cast<double>(node.x) * patch_squares + i) * scale - 1.0,
                     (static_cast<double>(node.y) * patch_squares + j) * scale - 1.0);
}

Node node_of(Vec3 d, int level) {
    const FacePoint p = face_point(d);
    return {p.face, level, cell(gathered(p.a), level), cell(gathered(p.b), level)};
}

Cap cap_of(const Node& node) {
    const Vec3 centre = vertex_direction(node, patch_squares / 2, patch_squares / 2);
    double angle = 0.0;
    for (const int i : {0, patch_squares})
        for (const int j : {0, patch_squares}) angle = std::max(angle, angle_between(centre, vertex_direction(node, i, j)));
    return {centre, angle};
}

double side_m(int level, double radius_m) { return std::ldexp(0.5 * pi * radius_m, -level); }

double angle_between(Vec3 a, Vec3 b) { return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)); }

}  // namespace airlight
