// Whole frames: a night without moon is as bright as dark skies were measured to be, by any method of air; a frame in parts is the frame.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <optional>

#include "atmosphere/presets.h"
#include "celestial/night_sky.h"
#include "render/air_airlight.h"
#include "render/air_exact.h"
#include "render/frame.h"
#include "spectrum/colour.h"
#include "terrain/raster_relief.h"
#include "terrain/surface_image.h"
#include "tools/gpu_case.h"
#include "tools/quick_bake.h"
#include "tools/temporary_folder.h"
#include "transport/table_cache.h"

using namespace airlight;
using namespace airlight::test;

namespace {

// A sphere of grey ground under one star that no picture of a night here shows.
class Planet {
public:
    explicit Planet(const GpuCase& gpu) : gpu_(&gpu) {}

    render::Frame frame(Result<std::unique_ptr<render::AirMethod>> method, const Camera& like, const HeightField& ground) const {
        REQUIRE(method);
        Result<render::AirPass> air = render::AirPass::create({atmosphere_, wavelengths, colours}, *std::move(method));
        REQUIRE(air);
        const GroundColour grey{std::make_shared<const SurfaceImage>(SurfaceImage{2, 1, {89, 89, 89, 255, 89, 89, 89, 255}})};
        const Star star{towards(90.0, 30.0), {1e-6, 1e-6, 1e-6}};
        Result<render::Frame> made = render::Frame::create(gpu_->context(), ground, grey, like, *std::move(air), {}, std::span(&star, 1));
        REQUIRE(made);
        return *std::move(made);
    }
    render::Frame airlight(const Camera& like) const {
        return frame(render::airlight_air(tables_, colours), like, level_height(radius_m()));
    }
    render::Frame exact(const Camera& like) const { return frame(render::exact_air(tables_, colours), like, level_height(radius_m())); }
    render::Frame airlight_over_the_sea(const Camera& like) const {
        const HeightField sea{.radius_m = radius_m(),
                              .sample =
                                  [](Vec3, double) {
                                      return HeightSample{-100.0, Vec3(0.0), Vec3(0.0), Vec3(0.0)};
                                  },
                              .range =
                                  [](const Cap&) {
                                      return Interval{-100.0, -100.0};
                                  },
                              .detail = [](double) { return 0.0; },
                              .whole = {-100.0, -100.0},
                              .sea = true};
        return frame(render::airlight_air(tables_, colours), like, sea);
    }

    // cd m-2 at midnight in the middle of a picture from 2 m above the ground.
    double luminance(render::Frame& frame, double elevation_deg) const {
        const Result<Image> image =
            frame.draw(narrow(elevation_deg), {.towards_sun = towards(0.0, -60.0), .sun = Vec3(1.0), .sky = Vec3(0.0)});
        REQUIRE(image);
        const std::span<const float> rgb = image->pixel(1, 1);
        return RgbConverter(RgbSpace::srgb, WhitePoint::d65).luminance({rgb[0], rgb[1], rgb[2]});
    }

    double radius_m() const { return atmosphere_.bottom_radius.in(m); }
    Vec3 towards(double heading_deg, double elevation_deg) const {
        return look(Viewpoint{.heading = heading_deg * deg, .pitch = elevation_deg * deg}, radius_m()).forward;
    }
    Camera narrow(double elevation_deg) const {
        Camera camera = look(Viewpoint{.altitude_m = 2.0, .pitch = elevation_deg * deg}, radius_m());
        camera.vertical_field_of_view = 0.1 * deg;
        camera.width = camera.height = 3;
        return camera;
    }

private:
    const GpuCase* gpu_;
    Atmosphere atmosphere_ = *preset("earth-clear");
    TemporaryFolder cache_;
    Tables tables_ = *cached_tables(atmosphere_, wavelengths, bake, {.folder = cache_.path}, {});
};

}  // namespace

TEST_CASE("a night without moon is as dark as dark sites are, somewhat brighter towards the horizon, and not black to the ground") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const Planet planet(gpu_case);
    render::Frame frame = planet.airlight(planet.narrow(0.0)), exact = planet.exact(planet.narrow(0.0));
    const auto luminance = [&](double elevation_deg) { return planet.luminance(frame, elevation_deg); };
    const double zenith = luminance(90.0);
    const double magnitude = 27.78 - 2.5 * std::log10(zenith / luminance_of_s10());
    fmt::print("  zenith {:.2f} mag arcsec-2, {:.2e} cd m-2\n", magnitude, zenith);
    CHECK(magnitude > 21.5);
    CHECK(magnitude < 22.0);
    // A quarter of a magnitude brighter through half as much air again [BennEllison1998]; near the horizon the air takes it back.
    const auto brighter = [&](double elevation_deg) { return 2.5 * std::log10(luminance(elevation_deg) / zenith); };
    for (const double elevation_deg : {41.8, 10.0, 3.0, 0.5})
        fmt::print("  {:4.1f} deg: {:.2f} mag\n", elevation_deg, brighter(elevation_deg));
    CHECK(brighter(41.8) == doctest::Approx(0.25).epsilon(0.4));
    CHECK(brighter(10.0) > brighter(41.8));
    CHECK(brighter(0.5) < brighter(10.0));
    CHECK(brighter(0.5) > -0.5);
    // Grey ground reflects a tenth of the light that falls on it.
    CHECK(luminance(-80.0) == doctest::Approx(0.1 / pi * illuminance(night_sky()).y).epsilon(0.1));
    for (const double elevation_deg : {90.0, 10.0, -80.0})
        CHECK(planet.luminance(exact, elevation_deg) == doctest::Approx(luminance(elevation_deg)).epsilon(0.02));
}

// Waves mirror a third to a half of a sky at this angle, in a wind of 7 m/s [CoxMunk1954].
TEST_CASE("a night's sky is mirrored by the sea, which is brighter than the ground towards the horizon") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const Planet planet(gpu_case);
    render::Frame sea = planet.airlight_over_the_sea(planet.narrow(0.0)), ground = planet.airlight(planet.narrow(0.0));
    const double mirrored = planet.luminance(sea, -3.0), mean = mean_luminance(night_sky()).y;
    fmt::print("  the sea has {:.2f} of the sky's light\n", mirrored / mean);
    CHECK(mirrored > 0.2 * mean);
    CHECK(mirrored < 0.6 * mean);
    CHECK(mirrored > 1.5 * planet.luminance(ground, -3.0));
}

TEST_CASE("a frame in parts is the frame drawn at once, by day and under the moon, and what stood there before leaves no trace") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const Planet planet(gpu_case);
    Camera camera = look(Viewpoint{.altitude_m = 500.0, .heading = 20.0 * deg}, planet.radius_m());
    camera.width = 16, camera.height = 11;
    Camera elsewhere = look(Viewpoint{.altitude_m = 9e3, .pitch = -40.0 * deg}, planet.radius_m());
    elsewhere.width = 16, elsewhere.height = 11;
    render::Frame frame = planet.exact(camera);
    const Vec3 moon_m = Vec3(planet.radius_m(), 0.0, 0.0) + 3.844e8 * planet.towards(10.0, 25.0);
    for (const double sun_deg : {12.0, -30.0}) {
        const render::Lights lights{
            .towards_sun = planet.towards(0.0, sun_deg), .sun = Vec3(1.0), .sky = Vec3(0.0), .sun_distance_au = 1.0, .moon_m = moon_m};
        const Result<Image> whole = frame.draw(camera, lights);
        REQUIRE(whole);
        const Result<Image> other = frame.draw(elsewhere, lights);
        REQUIRE(other);
        CHECK(other->values != whole->values);
        for (const render::Part& part : {render::Part{0, 8, 16, 3}, {0, 7, 5, 1}, {5, 7, 11, 1}, {0, 0, 16, 7}}) {
            CHECK(frame.image().values != whole->values);
            REQUIRE(frame.render(camera, lights, part));
        }
        CHECK(frame.image().values == whole->values);
    }
}
