// The camera: its frame, what its frustum holds, and where its places are.

#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <tuple>

#include "camera/camera.h"

using namespace airlight;

TEST_CASE("a camera's frame is right-handed and of length one, whatever it is made from") {
    const Camera c = look(Vec3(1, 2, 3), Vec3(3, -1, 0.2), Vec3(0.1, 0.5, 7));
    CHECK(glm::length(c.right) == doctest::Approx(1.0));
    CHECK(glm::length(c.up) == doctest::Approx(1.0));
    CHECK(glm::length(glm::cross(c.right, c.up) + c.forward) < 1e-15);
    CHECK(glm::dot(c.up, Vec3(0.1, 0.5, 7)) > 0.0);
}

TEST_CASE("a place's frame is east-north-up, with headings clockwise from north") {
    const double r = 6.36e6;
    const Camera north = look(Viewpoint{.latitude = 0.3, .longitude = 1.1}, r);
    CHECK(north.forward.z > 0.9);
    CHECK(glm::length(north.eye) == doctest::Approx(r + 2.0).epsilon(1e-15));
    const Camera east = look(Viewpoint{.latitude = 0.3, .longitude = 1.1, .heading = 90.0 * deg}, r);
    CHECK(glm::length(east.forward - north.right) < 1e-15);
    const Camera down = look(Viewpoint{.latitude = 0.3, .longitude = 1.1, .pitch = -90.0 * deg}, r);
    CHECK(glm::length(down.forward + direction_of(0.3, 1.1)) < 1e-15);
}

TEST_CASE("the frustum holds what the picture shows, to its edges") {
    Camera c = look(Vec3(5, 6, 7), Vec3(1, 1, -2), Vec3(0, 0, 1));
    c.width = 300, c.height = 200, c.vertical_field_of_view = 40.0 * deg;
    const Frustum planes = frustum(c);
    for (double x = -1.2; x <= 1.21; x += 0.1)
        for (double y = -1.2; y <= 1.21; y += 0.1) {
            double least = 1.0;
            for (const Vec3& normal : planes) least = std::min(least, glm::dot(normal, direction_at(c, x, y)));
            if (std::abs(x) < 0.99 && std::abs(y) < 0.99) CHECK(least > 0.0);
            if (std::abs(x) > 1.01 || std::abs(y) > 1.01) CHECK(least < 0.0);
        }
    CHECK(std::acos(glm::dot(direction_at(c, 0, 1), direction_at(c, 0, -1))) == doctest::Approx(40.0 * deg));
    // In the middle, a pixel is as wide as 1 / pixels_per_radian.
    CHECK(std::acos(glm::dot(direction_at(c, 0, 0), direction_at(c, 2.0 / 300.0, 0))) ==
          doctest::Approx(1.0 / pixels_per_radian(c)).epsilon(1e-4));
}

TEST_CASE("of the samples of a pixel one is in each of as many columns and rows, and their mean is its middle") {
    Camera c = look(Vec3(5, 6, 7), Vec3(1, 1, -2), Vec3(0, 0, 1));
    CHECK(sampled(c, 0, 1).shift_x == 0.0);
    CHECK(sampled(c, 0, 1).shift_y == 0.0);
    for (const int samples : {1, 2, 4, 16, 64}) {
        std::set<double> columns, rows;
        double x = 0.0, y = 0.0;
        for (int n = 0; n < samples; ++n) {
            const Camera s = sampled(c, n, samples);
            columns.insert((s.shift_x + 0.5) * samples - 0.5);
            rows.insert((s.shift_y + 0.5) * samples - 0.5);
            x += s.shift_x, y += s.shift_y;
        }
        CHECK(x == 0.0);
        CHECK(y == 0.0);
        for (const std::set<double>& places : {columns, rows}) {
            CHECK(places.size() == static_cast<std::size_t>(samples));
            CHECK(*places.begin() == 0.0);
            CHECK(*places.rbegin() == samples - 1.0);
        }
    }
}

TEST_CASE("a camera that is shifted by a pixel sees in each what the next one saw, and no more") {
    Camera c = look(Vec3(5, 6, 7), Vec3(1, 1, -2), Vec3(0, 0, 1));
    c.width = 300, c.height = 200, c.vertical_field_of_view = 70.0 * deg;
    Camera right = c, up = c;
    right.shift_x = 1.0, up.shift_y = 1.0;
    for (const double x : {-1.0, -0.2, 0.9})
        for (const double y : {-1.0, 0.3, 0.98}) {
            CHECK(glm::length(direction_at(right, x, y) - direction_at(c, x + 2.0 / 300.0, y)) < 1e-15);
            CHECK(glm::length(direction_at(up, x, y) - direction_at(c, x, y + 2.0 / 200.0)) < 1e-15);
        }
    for (const Camera& shifted : {right, up})
        for (const auto& [x, y, plane] : {std::tuple{-1.0, 0.4, 0}, {1.0, 0.4, 1}, {0.4, -1.0, 2}, {0.4, 1.0, 3}})
            CHECK(std::abs(glm::dot(frustum(shifted)[static_cast<std::size_t>(plane)], direction_at(shifted, x, y))) < 1e-15);
}
