// Projections: pixels to directions and back.

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

#include "image/projection.h"

using namespace airlight;

namespace {

const Vec3 east(1, 0, 0), north(0, 1, 0), up(0, 0, 1);

bool near(Vec3 a, Vec3 b, double bound) { return glm::length(a - b) <= bound; }
bool near(std::optional<Vec3> a, Vec3 b, double bound = 1e-14) { return a && near(*a, b, bound); }
bool near(std::optional<ImagePoint> a, ImagePoint b, double bound = 1e-9) { return a && std::hypot(a->x - b.x, a->y - b.y) <= bound; }

Projection example(int i) {
    switch (i) {
        case 0:
            return FullSphere{64, 32};
        case 1:
            return FullSphere{50, 33, 77.0 * deg};
        case 2:
            return Fisheye{40, 40};
        case 3:
            return Fisheye{41, 60, Fisheye::Law::equal_area, 220.0 * deg, 130.0 * deg};
        case 4:
            return Perspective{48, 27, 200.0 * deg, 20.0 * deg, -15.0 * deg, 70.0 * deg};
        default:
            return CubeMap{16};
    }
}

double sum_of_solid_angles(const Projection& projection) {
    double sum = 0.0;
    for (int row = 0; row < image_size(projection).height; ++row)
        for (int column = 0; column < image_size(projection).width; ++column) sum += pixel_solid_angle(projection, column, row);
    return sum;
}

}  // namespace

TEST_CASE("an angle's direction has that angle") {
    CHECK(near(sky_direction({90.0 * deg, 90.0 * deg}), east, 1e-15));
    CHECK(near(sky_direction({0.0, 90.0 * deg}), north, 1e-15));
    CHECK(near(sky_direction({123.0, 0.0}), up, 1e-15));
    for (double azimuth = 0.0; azimuth < 6.28; azimuth += 0.1)
        for (double zenith = 0.01; zenith < 3.14; zenith += 0.1) {
            const SkyAngles back = sky_angles(sky_direction({azimuth, zenith}));
            CHECK(std::abs(back.azimuth - azimuth) < 1e-13);
            CHECK(std::abs(back.zenith - zenith) < 1e-13);
        }
    CHECK(sky_angles({-1e-300, 1.0, 0.0}).azimuth < 2.0 * pi);
}

TEST_CASE("every pixel's centre that sees a direction is the point that sees it") {
    for (int i = 0; i < 6; ++i) {
        CAPTURE(i);
        const Projection projection = example(i);
        REQUIRE(check(projection));
        int seen = 0;
        for (int row = 0; row < image_size(projection).height; ++row)
            for (int column = 0; column < image_size(projection).width; ++column) {
                const ImagePoint centre{column + 0.5, row + 0.5};
                const std::optional<Vec3> d = direction(projection, centre);
                CHECK((d.has_value() == (pixel_solid_angle(projection, column, row) > 0.0)));
                if (!d) continue;
                ++seen;
                CHECK(std::abs(glm::length(*d) - 1.0) < 1e-14);
                // 1e-12 rad of rounding, less than 100 pixels a radian; asin and acos near their ends cost the square root.
                CHECK(near(image_point(projection, *d), centre, 1e-9));
            }
        CHECK(seen > 500);
    }
}

TEST_CASE("every direction that an image shows comes back from the point that shows it") {
    std::mt19937_64 random(20260103);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 6; ++i) {
        CAPTURE(i);
        const Projection projection = example(i);
        int shown = 0;
        for (int k = 0; k < 500; ++k) {
            const Vec3 d = glm::normalize(Vec3(normal(random), normal(random), normal(random)));
            const std::optional<ImagePoint> p = image_point(projection, d);
            if (!p) continue;
            ++shown;
            CHECK(near(direction(projection, *p), d, 1e-12));
        }
        CHECK(shown > (i == 4 ? 20 : 200));
    }
}

TEST_CASE("the pixels of the whole sphere and of a cube have 4 pi of solid angle together") {
    // Exact pixel by pixel: what is left is rounding of some thousand terms.
    CHECK(std::abs(sum_of_solid_angles(FullSphere{64, 32}) - 4.0 * pi) < 1e-11);
    CHECK(std::abs(sum_of_solid_angles(FullSphere{7, 5}) - 4.0 * pi) < 1e-11);
    CHECK(std::abs(sum_of_solid_angles(CubeMap{16}) - 4.0 * pi) < 1e-11);
    CHECK(std::abs(sum_of_solid_angles(CubeMap{1}) - 4.0 * pi) < 1e-11);
}

TEST_CASE("the pixels of a fisheye that sees half the sphere have 2 pi of solid angle together") {
    // Pixels at the edge count wholly or not at all: some sqrt(2 pi 100) = 25 of 31416 pixels too many or too few.
    CHECK(std::abs(sum_of_solid_angles(Fisheye{200, 200}) / (2.0 * pi) - 1.0) < 1e-3);
    CHECK(std::abs(sum_of_solid_angles(Fisheye{200, 200, Fisheye::Law::equal_area}) / (2.0 * pi) - 1.0) < 1e-3);
    CHECK(std::abs(sum_of_solid_angles(Fisheye{200, 200, Fisheye::Law::equal_area, 360.0 * deg}) / (4.0 * pi) - 1.0) < 1e-3);
}

TEST_CASE("the pixels of a camera have the solid angle of its field") {
    // A square field of 90 degrees is a face of a cube.
    CHECK(std::abs(sum_of_solid_angles(Perspective{20, 20, 1.0, 0.3, 0.2, 90.0 * deg}) - 4.0 * pi / 6.0) < 1e-12);
}

TEST_CASE("the full sphere has the zenith at the top, south in the middle, west to the right of it") {
    const FullSphere p{360, 180};
    CHECK(near(direction(p, {10.0, 0.0}), up));
    CHECK(near(direction(p, {180.0, 90.0}), -north));
    CHECK(near(direction(p, {270.0, 90.0}), -east));
    CHECK(near(direction(p, {0.0, 90.0}), north));
    CHECK(near(direction(FullSphere{360, 180, 0.0}, {180.0, 90.0}), north));
}

TEST_CASE("the fisheye looks up: north at the top, east on the left, nothing outside of the circle") {
    const Fisheye p{100, 100};
    CHECK(near(direction(p, {50.0, 50.0}), up));
    CHECK(near(direction(p, {50.0, 0.0}), north));
    CHECK(near(direction(p, {0.0, 50.0}), east));
    CHECK(near(direction(Fisheye{100, 100, Fisheye::Law::equidistant, 180.0 * deg, 90.0 * deg}, {50.0, 0.0}), east));
    CHECK(!direction(p, {1.0, 1.0}));
    CHECK(!image_point(p, glm::normalize(Vec3(1.0, 0.0, -0.01))));
}

TEST_CASE(
    "equal steps from the middle of the equidistant fisheye are equal zenith angles, equal areas of the other equal solid "
    "angles") {
    const Fisheye equidistant{100, 100}, equal_area{100, 100, Fisheye::Law::equal_area};
    CHECK(std::abs(sky_angles(*direction(equidistant, {50.0, 25.0})).zenith - 45.0 * deg) < 1e-14);
    CHECK(pixel_solid_angle(equal_area, 50, 50) == pixel_solid_angle(equal_area, 80, 30));
    // At zenith 60 degrees the equidistant law gives less sky a pixel than overhead: sin(z) / z.
    CHECK(std::abs(pixel_solid_angle(equidistant, 50, 16) / pixel_solid_angle(equidistant, 50, 50) - std::sin(60.3 * deg) / (60.3 * deg)) <
          1e-3);
}

TEST_CASE("a level camera that looks north has east on its right and the sky above") {
    const Perspective camera{200, 100};
    CHECK(near(direction(camera, {100.0, 50.0}), north));
    CHECK(near(direction(camera, {100.0, 0.0}), glm::normalize(Vec3(0.0, std::cos(30.0 * deg), std::sin(30.0 * deg)))));
    CHECK(direction(camera, {150.0, 50.0})->x > 0.1);
    CHECK(!image_point(camera, -north));
}

TEST_CASE("heading turns a camera right, pitch raises it, roll tilts it clockwise") {
    CHECK(near(direction(Perspective{100, 100, 90.0 * deg}, {50.0, 50.0}), east));
    CHECK(near(direction(Perspective{100, 100, 0.0, 90.0 * deg}, {50.0, 50.0}), up));
    // Tilted clockwise by a quarter turn, the top of the image looks where the right was: east.
    CHECK(direction(Perspective{100, 100, 0.0, 0.0, 90.0 * deg}, {50.0, 0.0})->x > 0.4);
}

TEST_CASE("the middle of a cube map's faces are the axes, in OpenGL's order") {
    const Vec3 middles[] = {east, -east, north, -north, up, -up};
    for (int i = 0; i < 6; ++i) CHECK(near(direction(CubeMap{10}, {5.0, 5.0 + 10.0 * i}), middles[i]));
    // OpenGL's rule for +x: s falls with z, t falls with y.
    CHECK(direction(CubeMap{10}, {0.0, 5.0})->z > 0.7);
    CHECK(direction(CubeMap{10}, {5.0, 0.0})->y > 0.7);
}

TEST_CASE("a projection that cannot be is refused with the rule") {
    const auto complaint = [](const Projection& p) {
        const Result<Done> checked = check(p);
        return checked ? std::string("accepted") : checked.error().message();
    };
    CHECK(complaint(FullSphere{0, 10}) == "an image of 0 x 10 pixels is out of range: each side has 1 to 65536");
    CHECK(complaint(FullSphere{10, -1}).starts_with("an image of 10 x -1"));
    CHECK(complaint(FullSphere{65536, 65536}).find("too large") != std::string::npos);
    CHECK(complaint(CubeMap{400000000}).starts_with("a cube map with faces of 400000000 pixels"));
    CHECK(complaint(Fisheye{10, 10, Fisheye::Law::equidistant, 361.0 * deg}).starts_with("a fisheye's field of 361 deg"));
    CHECK(complaint(Perspective{10, 10, 0.0, 0.0, 0.0, 180.0 * deg}).starts_with("a vertical field of view of 180 deg"));
    CHECK(complaint(Perspective{10, 10, std::numeric_limits<double>::quiet_NaN()}) == "an angle of the projection is not finite");
}
