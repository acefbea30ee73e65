// A night without moon as whole frames: as bright as dark skies were measured to be, seen through the air, by any method of it.

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
#include "tools/temporary_folder.h"
#include "transport/table_cache.h"

using namespace airlight;
using namespace airlight::test;

namespace {

// Three of them are the three channels.
const std::vector<Wavelength> wavelengths = {450.0 * nm, 500.0 * nm, 550.0 * nm, 650.0 * nm};
const std::vector<Vec3> colours = {{0, 0, 1}, {0, 0, 0}, {0, 1, 0}, {1, 0, 0}};
const BakeSettings bake = {
    .sizes = {.transmittance_mu = 64, .transmittance_altitude = 32, .sun = 24, .azimuth = 4, .view = 8, .altitude = 12}, .orders = 2};

// A night over a sphere of grey ground, under one star that no picture here shows.
class Night {
public:
    explicit Night(const GpuCase& gpu) : gpu_(&gpu) {}

    render::Frame frame(Result<std::unique_ptr<render::AirMethod>> method) const {
        REQUIRE(method);
        Result<render::AirPass> air = render::AirPass::create({atmosphere_, wavelengths, colours}, *std::move(method));
        REQUIRE(air);
        const GroundColour grey{std::make_shared<const SurfaceImage>(SurfaceImage{2, 1, {89, 89, 89, 255, 89, 89, 89, 255}})};
        const Star star{towards(90.0, 30.0), {1e-6, 1e-6, 1e-6}};
        Result<render::Frame> made =
            render::Frame::create(gpu_->context(), level_height(radius_m()), grey, camera(0.0), *std::move(air), {}, std::span(&star, 1));
        REQUIRE(made);
        return *std::move(made);
    }
    render::Frame airlight() const { return frame(render::airlight_air(tables_, colours)); }
    render::Frame exact() const { return frame(render::exact_air(tables_, colours)); }

    // cd m-2 in the middle of a picture from 2 m above the ground.
    double luminance(render::Frame& frame, double elevation_deg) const {
        const Result<Image> image =
            frame.draw(camera(elevation_deg), {.towards_sun = towards(0.0, -60.0), .sun = Vec3(1.0), .sky = Vec3(0.0)});
        REQUIRE(image);
        const std::span<const float> rgb = image->pixel(1, 1);
        return RgbConverter(RgbSpace::srgb, WhitePoint::d65).luminance({rgb[0], rgb[1], rgb[2]});
    }

private:
    double radius_m() const { return atmosphere_.bottom_radius.in(m); }
    Vec3 towards(double heading_deg, double elevation_deg) const {
        return look(Viewpoint{.heading = heading_deg * deg, .pitch = elevation_deg * deg}, radius_m()).forward;
    }
    Camera camera(double elevation_deg) const {
        Camera camera = look(Viewpoint{.altitude_m = 2.0, .pitch = elevation_deg * deg}, radius_m());
        camera.vertical_field_of_view = 0.1 * deg;
        camera.width = camera.height = 3;
        return camera;
    }

    const GpuCase* gpu_;
    Atmosphere atmosphere_ = *preset("earth-clear");
    TemporaryFolder cache_;
    Tables tables_ = *cached_tables(atmosphere_, wavelengths, bake, {.folder = cache_.path}, {});
};

}  // namespace

TEST_CASE("a night without moon is as dark as dark sites are, somewhat brighter towards the horizon, and not black to the ground") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const Night night(gpu_case);
    render::Frame frame = night.airlight(), exact = night.exact();
    const auto luminance = [&](double elevation_deg) { return night.luminance(frame, elevation_deg); };
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
        CHECK(night.luminance(exact, elevation_deg) == doctest::Approx(luminance(elevation_deg)).epsilon(0.02));
}
