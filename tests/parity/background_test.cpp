// What stands above the air, as the pass of the background draws it: light that adds up to what was published, at any resolution, in the
// right place.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "atmosphere/presets.h"
#include "celestial/eclipse.h"
#include "celestial/night_sky.h"
#include "celestial/refraction.h"
#include "render/background_pass.h"
#include "render/camera_block.h"
#include "spectrum/colour.h"
#include "tools/gpu_case.h"

using namespace airlight;
using namespace airlight::test;
using namespace airlight::render;

namespace {

constexpr double bottom_m = 6371e3;

Camera camera_towards(double elevation, double field, int width, int height) {
    Camera camera = look(Viewpoint{.altitude_m = 2.0, .heading = 0.0, .pitch = elevation}, bottom_m);
    camera.vertical_field_of_view = field;
    camera.width = width, camera.height = height;
    return camera;
}

// Northward over the place of camera_towards().
Vec3 direction_at_elevation(double elevation) { return look(Viewpoint{.heading = 0.0, .pitch = elevation}, bottom_m).forward; }

struct Picture {
    Camera camera;
    std::vector<float> pixels;  // red, green, blue, 0; the lowest row first

    double luminance(int column, int row) const {
        const float* p = &pixels[static_cast<std::size_t>(4 * (row * camera.width + column))];
        return RgbConverter(RgbSpace::srgb, WhitePoint::d65).luminance({p[0], p[1], p[2]});
    }
    // Sums of the value of each pixel, weighted by its solid angle and what `weight` says of its place, from -1 to 1.
    template <class Weight>
    double lux(Weight weight) const {
        const HalfSize half = half_size(camera);
        double sum = 0.0;
        for (int row = 0; row < camera.height; ++row)
            for (int column = 0; column < camera.width; ++column) {
                const double x = (column + 0.5) / camera.width * 2.0 - 1.0, y = (row + 0.5) / camera.height * 2.0 - 1.0;
                const double squared = 1.0 + x * x * half.width * half.width + y * y * half.height * half.height;
                const double solid = 4.0 * half.width * half.height / (camera.width * camera.height) / (squared * std::sqrt(squared));
                sum += luminance(column, row) * solid * weight(x, y);
            }
        return sum;
    }
    double lux() const {
        return lux([](double, double) { return 1.0; });
    }
};

BackgroundPass pass_for(const Camera& camera, std::span<const Star> stars) {
    Result<BackgroundPass> pass = BackgroundPass::create(camera.width, camera.height, stars);
    if (!pass) FAIL(pass.error().message());
    return *std::move(pass);
}

Picture draw(BackgroundPass& pass, const Camera& camera, const Heavens& heavens, const Atmosphere* air = nullptr) {
    const CameraBlock block;
    block.bind(camera);
    pass.draw(camera, heavens, bending_to(air, glm::length(camera.eye)), air);
    Picture picture{camera, std::vector<float>(static_cast<std::size_t>(4 * camera.width * camera.height))};
    pass.radiance().read(picture.pixels);
    return picture;
}
Picture draw(const Camera& camera, const Heavens& heavens, std::span<const Star> stars = {}, const Atmosphere* air = nullptr) {
    BackgroundPass pass = pass_for(camera, stars);
    return draw(pass, camera, heavens, air);
}

const Heavens sun_away = {.towards_sun = {-1.0, 0.0, 0.0}};

Heavens with_moon(Vec3 towards_sun, Vec3 towards_moon) {
    return {.towards_sun = towards_sun, .moon_m = Vec3(bottom_m, 0.0, 0.0) + 384.4e6 * towards_moon};
}

double luminance_of(RgbLight light) { return RgbConverter(RgbSpace::srgb, WhitePoint::d65).luminance({light.r, light.g, light.b}); }

}  // namespace

TEST_CASE("the sun's disk lights the ground with the sun's illuminance, as large as many pixels and smaller than one") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const double elevation = 30.0 * deg;
    const Heavens heavens{.towards_sun = direction_at_elevation(elevation)};
    const double expected = luminance_of(sunlight(heavens, SpectrumOf<Number>::constant(1.0)));
    CHECK(expected == doctest::Approx(133e3).epsilon(0.02));
    // Pixels that the limb cuts have its darkness: of a disk five pixels wide they are a third.
    for (const auto& [field_deg, tolerance] : {std::pair{2.0, 0.002}, {20.0, 0.06}, {60.0, 0.1}}) {
        const double lux = draw(camera_towards(elevation, field_deg * deg, 192, 192), heavens).lux();
        fmt::print("  field of {:4.0f} deg: {:.3f} of the sun's light\n", field_deg, lux / expected);
        CHECK(lux == doctest::Approx(expected).epsilon(tolerance));
    }
}

TEST_CASE("the moon lights the ground as it was measured to, at any phase, and its lit side is the sun's") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const double elevation = 40.0 * deg;
    const Vec3 towards_moon = direction_at_elevation(elevation);
    for (const double elongation_deg : {175.0, 135.0, 90.0, 40.0}) {
        // The sun to the right of the moon and as high.
        const Camera camera = camera_towards(elevation, 0.7 * deg, 160, 160);
        const Vec3 towards_sun = std::cos(elongation_deg * deg) * towards_moon + std::sin(elongation_deg * deg) * camera.right;
        const Heavens heavens = with_moon(towards_sun, towards_moon);
        const MoonSeen moon = *moon_seen(heavens, camera.eye);
        const Picture picture = draw(camera, heavens);
        const double dark = luminance_of(moon.dark) * pi * moon.angular_radius * moon.angular_radius;
        fmt::print("  elongation {:3.0f} deg: {:.4f} lux, of which the Earth's light {:.1e}\n", elongation_deg, picture.lux(), dark);
        CHECK(picture.lux() - dark == doctest::Approx(luminance_of(moon.illuminance)).epsilon(0.01));
        CHECK(picture.lux([](double x, double) { return x; }) > 0.0);
        CHECK(std::abs(picture.lux([](double, double y) { return y; })) < 1e-3 * picture.lux());
        // The dark limb has the Earth's light alone; beside it is nothing.
        if (elongation_deg <= 90.0) CHECK(picture.luminance(30, 80) == doctest::Approx(luminance_of(moon.dark)).epsilon(1e-3));
        CHECK(picture.luminance(5, 80) == 0.0);
    }
}

TEST_CASE("before the sun the moon leaves what the law of eclipses says") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const double elevation = 30.0 * deg;
    const Camera camera = camera_towards(elevation, 1.2 * deg, 256, 256);
    const Vec3 towards_sun = direction_at_elevation(elevation);
    const double whole = draw(camera, {.towards_sun = towards_sun}).lux();
    for (const double apart_deg : {0.1, 0.25, 0.4, 0.6}) {
        const Vec3 towards_moon = std::cos(apart_deg * deg) * towards_sun + std::sin(apart_deg * deg) * camera.right;
        const Heavens heavens = with_moon(towards_sun, towards_moon);
        const Eclipse eclipse = *eclipse_of(heavens, camera.eye, bottom_m);
        const double radius = std::asin(eclipse.moon_radius_m / glm::length(eclipse.moon_m));
        // Of green light.
        const std::array<RgbLight, 3> sun = sun_radiance(heavens);
        const double left =
            sunlight_left(covered_sun(apart_deg * deg, eclipse.sun_radius, radius), sun[1].g / sun[0].g, sun[2].g / sun[0].g);
        CHECK(draw(camera, heavens).lux() / whole == doctest::Approx(left).epsilon(0.01));
    }
    CHECK(!eclipse_of(with_moon(towards_sun, -towards_sun), camera.eye, bottom_m));
    CHECK(!eclipse_of(with_moon(towards_sun, direction_at_elevation(90.0 * deg)), camera.eye, bottom_m));
}

TEST_CASE("a star's light is the same at any resolution and anywhere between pixels, and the moon hides it") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const double elevation = 50.0 * deg;
    const Vec3 towards = direction_at_elevation(elevation);
    for (const double off_deg : {0.0, 0.013, 0.4, 11.0})
        for (const int pixels : {64, 100, 333}) {
            const Camera camera = camera_towards(elevation, 30.0 * deg, pixels, pixels);
            const std::vector<Star> star = {
                {std::cos(off_deg * deg) * towards + std::sin(off_deg * deg) * camera.right, {1e-6, 1e-6, 1e-6}}};
            CHECK(draw(camera, sun_away, star).lux() == doctest::Approx(1e-6).epsilon(0.01));
        }
    const Camera camera = camera_towards(elevation, 1.0 * deg, 64, 64);
    const std::vector<Star> star = {{towards, {1.0, 1.0, 1.0}}};
    CHECK(draw(camera, with_moon(camera.right, towards), star).lux() < 0.1);
}

TEST_CASE("stars that are taken later are drawn in place of those before, more of them or none") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const Camera camera = camera_towards(50.0 * deg, 30.0 * deg, 64, 64);
    const Vec3 towards = direction_at_elevation(50.0 * deg);
    const std::vector<Star> one = {{towards, {1e-6, 1e-6, 1e-6}}}, three(3, {towards, {1e-5, 1e-5, 1e-5}});
    BackgroundPass pass = pass_for(camera, {});
    for (const auto& [stars, lux] : {std::pair{one, 1e-6}, {three, 3e-5}, {one, 1e-6}, {{}, 0.0}}) {
        pass.take(stars);
        CHECK(draw(pass, camera, sun_away).lux() == doctest::Approx(lux).epsilon(0.01));
    }
}

TEST_CASE("air raises what stands low and flattens the sun") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const Atmosphere air = *preset("earth-clear");
    for (const double elevation_deg : {0.5, 5.0, 40.0}) {
        const double apparent = elevation_deg * deg, bent = bending(air, 2.0 * m, apparent);
        const Heavens heavens{.towards_sun = direction_at_elevation(apparent - bent)};
        const Camera camera = camera_towards(apparent, 1.0 * deg, 200, 200);
        const Picture picture = draw(camera, heavens, {}, &air);
        const double lux = picture.lux(), height = picture.lux([](double, double y) { return y * 0.5; }) / lux;  // degrees
        const double second = picture.lux([&](double, double y) { return (0.5 * y - height) * (0.5 * y - height); }) / lux;
        const double across = picture.lux([](double x, double) { return 0.25 * x * x; }) / lux;
        const double flattening = std::sqrt(second / across);
        const double expected = 1.0 / (1.0 - (bending(air, 2.0 * m, apparent + 0.002) - bending(air, 2.0 * m, apparent - 0.002)) / 0.004);
        fmt::print("  seen at {:4.1f} deg: {:+.4f} deg off, {:.3f} as high as wide, by the slope {:.3f}\n", elevation_deg, height,
                   flattening, expected);
        CHECK(std::abs(height) < 0.01);
        CHECK(flattening == doctest::Approx(expected).epsilon(0.01));
        const std::vector<Star> star = {{direction_at_elevation(apparent - bent), {1.0, 1.0, 1.0}}};
        const Picture point = draw(camera, sun_away, star, &air);
        CHECK(point.lux() == doctest::Approx(1.0).epsilon(0.01));
        CHECK(std::abs(point.lux([](double, double y) { return y * 0.5; })) < 0.002);
    }
}

TEST_CASE("at night the air glows by van Rhijn's law from below, and by its way through the glowing shell from space") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    Atmosphere air = *preset("earth-clear");
    air.bottom_radius = bottom_m * m;
    const NightSky sky = night_sky();
    const Heavens night{.towards_sun = {-1.0, 0.0, 0.0}, .night_sky = true};
    const auto seen = [&](double altitude_m, double elevation, const Atmosphere* glowing) {
        Camera camera = camera_towards(elevation, 0.02 * deg, 3, 3);
        camera.eye = camera.eye / bottom_m * (bottom_m + altitude_m);
        return draw(camera, night, {}, glowing).luminance(1, 1);
    };
    CHECK(seen(2.0, 90.0 * deg, nullptr) == doctest::Approx(sky.beyond.y).epsilon(1e-5));
    // A shell ten kilometres thick is a thin one but for 3 %, at the horizon.
    for (const double elevation_deg : {90.0, 45.0, 10.0, 1.0}) {
        const double elevation = elevation_deg * deg, glow = seen(2.0, elevation, &air) - sky.beyond.y;
        CHECK(glow == doctest::Approx(sky.airglow.y * van_rhijn(0.5 * pi - elevation)).epsilon(0.03));
    }
    for (const auto& [altitude_m, elevation_deg] : {std::pair{90e3, 20.0}, {90e3, -5.0}, {400e3, -18.0}, {400e3, -17.3}, {400e3, -10.0}}) {
        const double elevation = elevation_deg * deg, step_m = 10.0, r = bottom_m + altitude_m;
        double within_m = 0.0;
        for (double way_m = 0.5 * step_m; way_m < 5e6; way_m += step_m) {
            const double above_m = std::sqrt(r * r + way_m * way_m + 2.0 * r * way_m * std::sin(elevation)) - bottom_m;
            if (above_m > airglow_bottom.in(m) && above_m < airglow_top.in(m)) within_m += step_m;
        }
        const double expected = sky.beyond.y + sky.airglow.y * within_m / (airglow_top - airglow_bottom).in(m);
        CAPTURE(elevation_deg);
        CHECK(seen(altitude_m, elevation, &air) == doctest::Approx(expected).epsilon(0.005));
    }
}
