// The ground: noise and its slope, the cube's faces, bounds of nodes, and patches that meet without cracks and change without a jump.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "terrain/noise.h"
#include "terrain/octahedral.h"
#include "terrain/procedural_relief.h"
#include "terrain/quadtree.h"

using namespace airlight;

namespace {

constexpr unsigned seed = 20240611;

Vec3 random_direction(std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(Vec3(normal(random), normal(random), normal(random)));
}

// A planet of octaves as wide as kilometres: quick to compute, with all that the laws are about.
ProceduralRelief coarse_relief() {
    ProceduralRelief relief;
    relief.mountains.narrowest_m = 500.0;
    return relief;
}

Vec3 tangent_of(Vec3 d) { return glm::normalize(glm::cross(d, std::abs(d.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0))); }

// A camera above the ground of a direction, looking down a little.
Camera camera_above(const HeightField& field, Vec3 direction, double above_m, double pitch, int width = 640, int height = 360) {
    const double ground = field.sample(direction, 1.0).height_m;
    const Vec3 level = tangent_of(direction);
    Camera camera = look(direction * (field.radius_m + (field.sea ? std::max(0.0, ground) : ground) + above_m),
                         std::cos(pitch) * level + std::sin(pitch) * direction, direction);
    camera.width = width, camera.height = height;
    return camera;
}

using Point = std::array<double, 3>;
Point point(Vec3 p) { return {p.x, p.y, p.z}; }

// The triangles of a patch as an eye sees them, by their corners, without those that have become lines.
std::vector<std::array<Point, 3>> triangles_of(const Tile& tile, Vec3 eye, const LevelReach& reach) {
    std::vector<Point> at;
    for (int j = 0; j < patch_side; ++j)
        for (int i = 0; i < patch_side; ++i) at.push_back(point(glided_position(tile, i, j, eye, reach)));
    std::vector<std::array<Point, 3>> triangles;
    for (const std::array<std::uint16_t, 3>& t : patch_triangles()) {
        const std::array<Point, 3> corners = {at[t[0]], at[t[1]], at[t[2]]};
        if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0]) triangles.push_back(corners);
    }
    return triangles;
}

// The same triangles in an order that does not depend on where each begins.
std::vector<std::array<Point, 3>> sorted(std::vector<std::array<Point, 3>> triangles) {
    for (auto& t : triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

}  // namespace

TEST_CASE("noise: its gradient is the difference quotient of its value, and both keep their bounds") {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> place(-1e4, 1e4);
    constexpr double step = 1e-5;
    double largest_value = 0.0, largest_slope = 0.0;
    for (int n = 0; n < 200'000; ++n) {
        const Vec3 p(place(random), place(random), place(random));
        const NoiseSample s = gradient_noise(p, 7);
        largest_value = std::max(largest_value, std::abs(s.value));
        largest_slope = std::max(largest_slope, glm::length(s.gradient));
        if (n % 100) continue;
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 e(0.0);
            e[axis] = step;
            const double quotient = (gradient_noise(p + e, 7).value - gradient_noise(p - e, 7).value) / (2.0 * step);
            // Third derivatives below 100 leave step^2 / 6 of them; coordinates of 1e4 leave 1e-12 / step.
            CHECK(std::abs(quotient - s.gradient[axis]) < 1e-6);
        }
    }
    fmt::print("  largest value {:.3f} of {:.3f}, largest slope {:.3f} of {:.3f}\n", largest_value, noise_bound, largest_slope,
               noise_slope_bound);
    CHECK(largest_value <= noise_bound);
    CHECK(largest_slope <= noise_slope_bound);
    CHECK(largest_value > 0.6);  // the bound is not idle
    CHECK(gradient_noise({3.0, -5.0, 11.0}, 1).value == 0.0);
    CHECK(gradient_noise({0.4, 0.3, 0.2}, 1).value != gradient_noise({0.4, 0.3, 0.2}, 2).value);
}

TEST_CASE("relief: its slope is the difference quotient of its height, in every direction along the sphere") {
    ProceduralRelief relief;
    relief.mountains.narrowest_m = 50.0;
    const HeightField field = procedural_height(relief);
    std::mt19937_64 random(seed);
    constexpr double step_m = 0.1, narrow = 1.0;  // narrower than any feature: all are in the slope
    for (int n = 0; n < 200; ++n) {
        const Vec3 d = random_direction(random), e = tangent_of(d), f = glm::cross(d, e);
        const double turn = std::uniform_real_distribution<double>(0.0, 2.0 * pi)(random);
        const Vec3 along = std::cos(turn) * e + std::sin(turn) * f;
        const HeightSample s = field.sample(d, narrow);
        const auto height = [&](double way) { return field.sample(glm::normalize(d + along * (way / field.radius_m)), narrow).height_m; };
        CHECK(glm::dot(s.slope, d) == doctest::Approx(0.0).epsilon(1e-9));
        // (2 pi step / 50 m)^2 / 6 of the narrowest features' slope, and heights' rounding of 1e-11 m through directions of 1e-16.
        CHECK(std::abs((height(step_m) - height(-step_m)) / (2.0 * step_m) - glm::dot(s.slope, along)) < 2e-5);
    }
}

TEST_CASE("relief: the share of features in a slope grows smoothly from none to all") {
    CHECK(slope_weight(10.0, 10.0) == 0.0);
    CHECK(slope_weight(15.0, 10.0) == 0.5);
    CHECK(slope_weight(20.0, 10.0) == 1.0);
    const HeightField field = procedural_height(coarse_relief());
    const Vec3 d = glm::normalize(Vec3(1, 2, 3));
    // What is coarse at a width is fine at twice of it: levels hand their normals on.
    CHECK(glm::length(field.sample(d, 1000.0).coarse_slope - field.sample(d, 2000.0).slope) == 0.0);
    CHECK(field.sample(d, 1000.0).height_m == field.sample(d, 2000.0).height_m);
    CHECK(glm::length(field.sample(d, 1e8).slope) == 0.0);
}

TEST_CASE("a normal packed in two numbers of 16 bits comes back within 0.004 degrees") {
    std::mt19937_64 random(seed);
    double largest = 0.0;
    for (int n = 0; n < 100'000; ++n) {
        const Vec3 d = random_direction(random);
        largest = std::max(largest, angle_between(d, from_octahedral(octahedral(d))));
    }
    CHECK(largest < 0.004 * deg);
    for (const Vec3 axis : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)})
        CHECK(angle_between(axis, from_octahedral(octahedral(axis))) < 0.004 * deg);
}

TEST_CASE("faces of the cube share the vertices of their edges to the bit") {
    for (const int level : {0, 3}) {
        std::map<Point, std::set<int>> faces;
        const auto last = (std::uint32_t{1} << level) - 1;
        for (int face = 0; face < cube_faces; ++face)
            for (std::uint32_t n = 0; n <= last; ++n)
                for (int k = 0; k <= patch_squares; ++k) {
                    faces[point(vertex_direction({face, level, n, 0}, k, 0))].insert(face);
                    faces[point(vertex_direction({face, level, n, last}, k, patch_squares))].insert(face);
                    faces[point(vertex_direction({face, level, 0, n}, 0, k))].insert(face);
                    faces[point(vertex_direction({face, level, last, n}, patch_squares, k))].insert(face);
                }
        std::size_t corners = 0;
        for (const auto& [p, of] : faces) {
            CHECK((of.size() == 2 || of.size() == 3));
            corners += of.size() == 3;
        }
        CHECK(corners == 8);
        CHECK(faces.size() == 8 + 12 * ((std::size_t{patch_squares} << level) - 1));
    }
}

TEST_CASE("a direction lies in the node that says so, and children fill their parent") {
    std::mt19937_64 random(seed);
    for (int n = 0; n < 1000; ++n) {
        const Vec3 d = random_direction(random);
        const int level = static_cast<int>(random() % 23);
        const Node node = node_of(d, level);
        const Cap cap = cap_of(node);
        CHECK(angle_between(cap.centre, d) <= cap.angle + 1e-15);
        CHECK(node_of(cap.centre, level) == node);
        for (const Node& child : children(node)) CHECK(parent(child) == node);
        const auto c = children(node);
        CHECK(std::find(c.begin(), c.end(), node_of(d, level + 1)) != c.end());
        CHECK(2.0 * cap.angle * 6e6 <= 1.5 * side_m(level, 6e6) * 1.01);
    }
}

TEST_CASE("all of a node's ground lies within its bounds, and neither nearer nor farther than they say") {
    const HeightField field = procedural_height({});
    std::mt19937_64 random(seed);
    for (int n = 0; n < 300; ++n) {
        const Vec3 d = random_direction(random);
        const Node node = node_of(d, static_cast<int>(random() % 20));
        const NodeBounds bounds = bounds_of(node, field);
        const Vec3 along = random_direction(random);
        const Vec3 eye =
            random_direction(random) * (bounds.radii_m.high + std::exp(std::uniform_real_distribution<double>(0.0, 17.0)(random)));
        const Tile tile = build_tile(node, field);
        for (const TileVertex& v : tile.vertices) {
            const Vec3 p(v.position_m[0], v.position_m[1], v.position_m[2]);
            const double r = glm::length(p), rounding = 1e-8;
            CHECK((r >= bounds.radii_m.low - rounding && r <= bounds.radii_m.high + rounding));
            CHECK(angle_between(p / r, bounds.cap.centre) <= bounds.cap.angle + 1e-15);
            CHECK(distance_to(bounds, eye) <= glm::length(p - eye) + rounding);
            CHECK(glm::dot(p, along) <= farthest_along(bounds, along) + rounding);
        }
        CHECK(distance_to(bounds, bounds.cap.centre * bounds.radii_m.low) < 1e-8);
        // One of the bounds' own points is as far: on the rim of the cap, or in the direction itself.
        const Vec3 beside = glm::normalize(along - bounds.cap.centre * glm::dot(bounds.cap.centre, along));
        const Vec3 rim = bounds.cap.centre * std::cos(bounds.cap.angle) + beside * std::sin(bounds.cap.angle);
        const Vec3 nearest = angle_between(along, bounds.cap.centre) <= bounds.cap.angle ? along : rim;
        CHECK(farthest_along(bounds, along) ==
              doctest::Approx(std::max(glm::dot(nearest, along) * bounds.radii_m.low, glm::dot(nearest, along) * bounds.radii_m.high)));
    }
}

TEST_CASE("patches of all levels close to one surface without cracks: each side of a triangle is one of a neighbour's") {
    const HeightField field = procedural_height(coarse_relief());
    const LevelReach reach = level_reach(field, {.pixels_per_radian = 300.0, .finest_square_m = 500.0});
    const Vec3 places[] = {Vec3(1.0, 0.1, 0.2), Vec3(1.0, 1.0, 0.03), Vec3(1.0, 0.999, 1.001)};  // in a face, at an edge, at a corner
    for (const Vec3& place : places)
        for (const double above_m : {30.0, 40e3, 9e6}) {
            const Camera camera = camera_above(field, glm::normalize(place), above_m, -0.1);
            Quadtree tree(field, reach);
            const Selection selection = tree.select(camera, {.frustum = false, .horizon = false});
            std::vector<std::pair<Point, Point>> sides, turned;
            std::set<int> levels;
            for (const Node& node : selection.nodes) {
                levels.insert(node.level);
                for (const auto& t : triangles_of(build_tile(node, field), camera.eye, reach))
                    for (std::size_t k = 0; k < 3; ++k) {
                        sides.push_back({t[k], t[(k + 1) % 3]});
                        turned.push_back({t[(k + 1) % 3], t[k]});
                    }
            }
            std::sort(sides.begin(), sides.end());
            std::sort(turned.begin(), turned.end());
            CAPTURE(above_m);
            CHECK((sides == turned));
            CHECK(levels.size() >= (above_m < 1e6 ? 6 : 2));
        }
}

TEST_CASE("no popping: a patch that gives way to its children, or takes them back, changes nothing") {
    const HeightField field = procedural_height(coarse_relief());
    const LevelReach reach = level_reach(field, {.pixels_per_radian = 300.0});
    std::mt19937_64 random(seed);
    for (int n = 0; n < 60; ++n) {
        const int level = 1 + n % 12;
        const Node node = node_of(random_direction(random), level);
        const NodeBounds bounds = bounds_of(node, field);
        // Above the node, where the next level just no longer reaches.
        const double reach_m = reach.reach_m[static_cast<std::size_t>(level + 1)];
        const Vec3 eye = bounds.cap.centre * (bounds.radii_m.high + reach_m * (1.0 + 1e-9));
        std::vector<std::array<Point, 3>> fine;
        for (const Node& child : children(node)) {
            const auto t = triangles_of(build_tile(child, field), eye, reach);
            fine.insert(fine.end(), t.begin(), t.end());
        }
        CHECK(sorted(fine) == sorted(triangles_of(build_tile(node, field), eye, reach)));
    }
}

TEST_CASE("no popping: as the eye moves, a vertex moves by no more than its level's share of that") {
    const HeightField field = procedural_height({});
    const LevelReach reach = level_reach(field, {.pixels_per_radian = 300.0});
    std::mt19937_64 random(seed);
    double largest = 0.0;
    for (int n = 0; n < 400; ++n) {
        const int level = 1 + n % reach.deepest;
        const Tile tile = build_tile(node_of(random_direction(random), level), field);
        const TileVertex& v = tile.vertices[random() % patch_vertices];
        const Vec3 p(v.position_m[0], v.position_m[1], v.position_m[2]);
        const double reach_m = reach.reach_m[static_cast<std::size_t>(level)];
        const Vec3 eye = p + random_direction(random) * reach_m * std::uniform_real_distribution<double>(0.6, 1.2)(random);
        const double step = 1e-3 * reach_m;
        const Vec3 moved = eye + random_direction(random) * step;
        // A vertex crosses a square's diagonal, longer by what heights differ, over the last fifth of its reach.
        const double span = 2.0 * spacing_m(level, field.radius_m) + field.detail(spacing_m(level, field.radius_m));
        const double bound = span / ((1.0 - glide_begin) * reach_m);
        for (int j = 0; j < patch_side; ++j)
            for (int i = 0; i < patch_side; ++i) {
                const double by = glm::length(glided_position(tile, i, j, moved, reach) - glided_position(tile, i, j, eye, reach));
                CHECK(by <= bound * step * 1.5);  // two levels may glide at once beyond the first one's reach
                largest = std::max(largest, by / step);
            }
    }
    fmt::print("  a vertex moves by at most {:.3f} of the eye's way\n", largest);
}

TEST_CASE("neighbours of different levels have the same vertices, heights and covers to the bit") {
    const HeightField field = procedural_height(coarse_relief());
    std::mt19937_64 random(seed);
    for (int n = 0; n < 20; ++n) {
        const Node node = node_of(random_direction(random), 1 + n % 10);
        const Tile coarse = build_tile(node, field);
        const auto four = children(node);
        for (std::size_t c = 0; c < 4; ++c) {
            const Tile fine = build_tile(four[c], field);
            for (int j = 0; j < patch_side; j += 2)
                for (int i = 0; i < patch_side; i += 2) {
                    const int ci = i / 2 + (c % 2 ? patch_squares / 2 : 0), cj = j / 2 + (c / 2 ? patch_squares / 2 : 0);
                    const TileVertex &a = fine.vertices[static_cast<std::size_t>(j * patch_side + i)],
                                     &b = coarse.vertices[static_cast<std::size_t>(cj * patch_side + ci)];
                    CHECK(a.position_m == b.position_m);
                    CHECK(a.height_m == b.height_m);
                    CHECK(a.cover == b.cover);
                    CHECK(a.coarse_normal == b.normal);  // what the finer level shows at the end of its reach
                }
        }
    }
}

TEST_CASE("culling never takes away what is seen, and takes away much") {
    const HeightField field = procedural_height(coarse_relief());
    std::mt19937_64 random(seed);
    std::size_t all = 0, kept = 0, tested = 0;
    for (int n = 0; n < 24; ++n) {
        const double above_m = std::exp(std::uniform_real_distribution<double>(std::log(2.0), std::log(2e7))(random));
        const Camera camera =
            camera_above(field, random_direction(random), above_m, std::uniform_real_distribution<double>(-1.2, 0.3)(random));
        Quadtree tree(field, level_reach(field, {.pixels_per_radian = pixels_per_radian(camera), .finest_square_m = 200.0}));
        const Selection whole = tree.select(camera, {.frustum = false, .horizon = false}), seen = tree.select(camera);
        const std::set<Node> left(seen.nodes.begin(), seen.nodes.end());
        all += whole.nodes.size(), kept += left.size();
        const double solid = tree.solid_m(camera.eye);
        const Frustum planes = frustum(camera);
        for (const Node& node : whole.nodes) {
            if (left.contains(node) || random() % 8) continue;
            for (const TileVertex& v : build_tile(node, field).vertices) {
                const Vec3 p(v.position_m[0], v.position_m[1], v.position_m[2]), way = p - camera.eye;
                bool inside = true;
                for (const Vec3& normal : planes) inside &= glm::dot(normal, way) >= 0.0;
                if (!inside) continue;
                // Nearest to the centre along the way.
                const double t = std::clamp(-glm::dot(camera.eye, way) / glm::dot(way, way), 0.0, 1.0);
                CHECK(glm::length(camera.eye + t * way) < solid);
                ++tested;
            }
        }
    }
    fmt::print("  {} of {} patches kept; {} vertices in the frustum and behind the horizon\n", kept, all, tested);
    CHECK(tested > 1000);
    CHECK(kept * 4 < all);
}

TEST_CASE("the number of patches stays bounded on the way from 20 000 km to 2 m") {
    const HeightField field = procedural_height({});
    const Vec3 d = glm::normalize(Vec3(0.4, -0.7, 0.5));
    const double ppr = pixels_per_radian(camera_above(field, d, 1.0, 0.0));
    Quadtree tree(field, level_reach(field, {.pixels_per_radian = ppr}));
    std::size_t most = 0;
    int deepest = 0;
    for (int frame = 0; frame <= 100; ++frame) {
        const double above_m = 2e7 * std::pow(2.0 / 2e7, frame / 100.0);
        const double dip = std::acos(field.radius_m / (field.radius_m + above_m));
        const Selection selection = tree.select(camera_above(field, d, above_m, -dip - 0.1));
        most = std::max(most, selection.nodes.size());
        for (const Node& node : selection.nodes) deepest = std::max(deepest, node.level);
        CHECK(selection.visited < 6000);
        CHECK(!selection.nodes.empty());
    }
    fmt::print("  at most {} patches, deepest level {} of {}\n", most, deepest, tree.reach().deepest);
    CHECK(most <= 1500);
    CHECK(deepest == tree.reach().deepest);
}
