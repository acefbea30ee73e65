// What pictures of a planet's air have suffered from [Sperlhofer2011, chapter 5], as laws of whole frames of the air in real time, over a ground
// that is a sphere; by the exact method where a law needs a truth. docs/gallery.md lists each artefact with its test.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "atmosphere/presets.h"
#include "image/exposure.h"
#include "image/png.h"
#include "image/tone.h"
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

struct Size {
    int width, height;
};

// The eye, the sun behind whose azimuth it looks by `aside`, and the picture's middle above the horizon.
struct Sight {
    double altitude_m, above_horizon_deg, sun_zenith_deg, aside_deg, field_deg;
};

class Planet {
public:
    explicit Planet(const GpuCase& gpu) : gpu_(&gpu) {}

    double radius_m() const { return atmosphere_.bottom_radius.in(m); }
    double horizon(double altitude_m) const { return std::acos(radius_m() / (radius_m() + altitude_m)); }

    Image airlight(const Sight& sight, Size size) const { return draw(render::airlight_air(tables_, colours), sight, size); }
    Image exact(const Sight& sight, Size size) const { return draw(render::exact_air(tables_, colours), sight, size); }

private:
    Image draw(Result<std::unique_ptr<render::AirMethod>> method, const Sight& sight, Size size) const {
        REQUIRE(method);
        Result<render::AirPass> air = render::AirPass::create({atmosphere_, wavelengths, colours}, *std::move(method));
        REQUIRE(air);
        Camera camera = look(Viewpoint{.altitude_m = sight.altitude_m,
                                       .heading = sight.aside_deg * deg,
                                       .pitch = sight.above_horizon_deg * deg - horizon(sight.altitude_m)},
                             radius_m());
        camera.vertical_field_of_view = sight.field_deg * deg;
        camera.width = size.width, camera.height = size.height;
        const Vec3 sun = look(Viewpoint{.heading = 0.0, .pitch = (90.0 - sight.sun_zenith_deg) * deg}, radius_m()).forward;
        const GroundColour grey{std::make_shared<const SurfaceImage>(SurfaceImage{2, 1, {89, 89, 89, 255, 89, 89, 89, 255}})};
        Result<render::Frame> frame = render::Frame::create(gpu_->context(), level_height(radius_m()), grey, camera, *std::move(air));
        REQUIRE(frame);
        Result<Image> image = frame->draw(camera, {.towards_sun = sun, .sun = Vec3(1.0), .sky = Vec3(0.0)});
        REQUIRE(image);
        return *std::move(image);
    }

    const GpuCase* gpu_;
    Atmosphere atmosphere_ = *preset("earth-clear");
    TemporaryFolder cache_;
    Tables tables_ = *cached_tables(atmosphere_, wavelengths, bake, {.folder = cache_.path}, {});
};

double at(const Image& image, int column, int row, std::size_t channel) { return static_cast<double>(image.pixel(column, row)[channel]); }

// How far the step from a row to the next is from the true one, at most, as a share of light.
double largest_false_step(const Image& seen, const Image& exact) {
    double worst = 0.0;
    for (int column = 0; column < seen.width; ++column)
        for (int row = 1; row < seen.height; ++row)
            for (std::size_t c = 0; c < 3; ++c) {
                const double step = std::log(at(seen, column, row, c) / at(seen, column, row - 1, c));
                const double true_step = std::log(at(exact, column, row, c) / at(exact, column, row - 1, c));
                worst = std::max(worst, std::abs(step - true_step));
            }
    return worst;
}

// As tables of 8 bits would hold it.
Image in_8_bits(Image image) {
    const float most = *std::max_element(image.values.begin(), image.values.end());
    for (float& value : image.values) value = std::max(1.0f, std::round(255.0f * value / most)) * most / 255.0f;
    return image;
}

// An edge of 1 to 2 % is just seen.
constexpr double seen_step = 0.015;

// Between the mean level of a row that a display shows and the mean of what it should show, the largest difference.
double largest_false_level(const Image& display,
                           const std::function<double(double level, int column, int row, std::size_t channel)>& shown) {
    double worst = 0.0;
    for (int row = 0; row < display.height; ++row)
        for (std::size_t c = 0; c < 3; ++c) {
            double sum = 0.0;
            for (int column = 0; column < display.width; ++column) {
                const double level = 255.0 * srgb_encoded(at(display, column, row, c));
                sum += shown(level, column, row, c) - level;
            }
            worst = std::max(worst, std::abs(sum) / display.width);
        }
    return worst;
}

}  // namespace

TEST_CASE("horizon: from row to row a frame steps as the exact one does, without a seam and without noise") {
    const GpuCase gpu;
    if (!gpu) return;
    const Planet planet(gpu);
    constexpr Size size{2, 128};
    double in_bytes = 0.0;
    for (const double altitude_m : {2.0, 2e3, 3e4})
        for (const double sun_deg : {60.0, 88.0}) {
            const Sight sight{altitude_m, 0.0, sun_deg, 40.0, 2.0};
            const Image seen = planet.airlight(sight, size), exact = planet.exact(sight, size);
            const double worst = largest_false_step(seen, exact);
            in_bytes = std::max(in_bytes, largest_false_step(in_8_bits(seen), exact));
            fmt::print("  {:>6.0f} m, sun {}: {:.4f}\n", altitude_m, sun_deg, worst);
            CHECK(worst <= seen_step);
        }
    fmt::print("  in 8 bits: {:.4f}\n", in_bytes);
    CHECK(in_bytes > seen_step);
}

TEST_CASE("below the horizon there is no light of aerosol's peak while the sun is down") {
    const GpuCase gpu;
    if (!gpu) return;
    const Planet planet(gpu);
    constexpr Size size{48, 16};
    for (const double altitude_m : {100.0, 3e3})
        for (const double sun_deg : {91.0, 93.0}) {
            const Sight sight{altitude_m, -3.1, sun_deg, 0.0, 6.0};
            const Image seen = planet.airlight(sight, size), exact = planet.exact(sight, size);
            double worst = 0.0;
            for (int row = 0; row < size.height; ++row)
                for (int column = 0; column < size.width; ++column)
                    for (std::size_t c = 0; c < 3; ++c) worst = std::max(worst, at(seen, column, row, c) / at(exact, column, row, c) - 1.0);
            fmt::print("  {:>6.0f} m, sun {}: {:.4f}\n", altitude_m, sun_deg, worst);
            CHECK(worst <= 0.05);
        }
}

TEST_CASE("a sky at dusk has no bands: its light steps as the exact one's does, and the levels of a display follow it") {
    const GpuCase gpu;
    if (!gpu) return;
    const Planet planet(gpu);
    const Sight dusk{2.0, 22.0, 93.0, 20.0, 40.0};
    CHECK(largest_false_step(planet.airlight(dusk, {2, 96}), planet.exact(dusk, {2, 96})) <= seen_step);

    // Away from the sun, where rows are even.
    const Image sky = planet.airlight({2.0, 40.0, 93.0, 180.0, 12.0}, {96, 96});
    const Image display = developed(sky, exposure_of_white(3.0 * at(sky, 48, 48, 2)), ToneCurve::filmic);
    const TemporaryFolder folder;
    REQUIRE(write_png(folder.path / "sky.png", display));
    const Result<PngLevels> written = read_png(folder.path / "sky.png");
    REQUIRE(written);
    const double dithered = largest_false_level(display, [&](double, int column, int row, std::size_t c) {
        return static_cast<double>(written->levels[3 * static_cast<std::size_t>(row * written->width + column) + c]);
    });
    // What is only rounded is off by half a level over whole rows: bands.
    const double rounded = largest_false_level(display, [](double level, int, int, std::size_t) { return std::round(level); });
    fmt::print("  levels: dithered {:.3f}, rounded {:.3f}\n", dithered, rounded);
    CHECK(dithered <= 0.1);
    CHECK(rounded > 0.2);
}

TEST_CASE("from 20 000 km light falls across the terminator without a bump, its edge is smooth, and the night is dark") {
    const GpuCase gpu;
    if (!gpu) return;
    const Planet planet(gpu);
    constexpr Size size{96, 96};
    const double altitude_m = 2e7;
    const Image seen = planet.airlight({altitude_m, -90.0 + planet.horizon(altitude_m) / deg, 90.0, 90.0, 32.0}, size);
    double brightest = 0.0;
    for (const float value : seen.values) brightest = std::max(brightest, static_cast<double>(value));
    std::vector<double> edge;  // where each row falls below a hundredth of the brightest
    for (int row = 24; row < 72; ++row) {
        int column = 16;
        for (; column < 80 && at(seen, column, row, 1) > 0.01 * brightest; ++column)
            CHECK(at(seen, column + 1, row, 1) < at(seen, column, row, 1));
        const double before = std::log(at(seen, column - 1, row, 1)), after = std::log(at(seen, column, row, 1));
        edge.push_back(column + (std::log(0.01 * brightest) - before) / (after - before));
        // 27 degrees beyond, where no sun has been in the air for long.
        CHECK(at(seen, 70, row, 1) < 1e-6 * brightest);
    }
    double worst = 0.0;
    for (std::size_t i = 1; i + 1 < edge.size(); ++i) worst = std::max(worst, std::abs(edge[i + 1] - 2.0 * edge[i] + edge[i - 1]));
    fmt::print("  the edge bends by {:.3f} pixels at most\n", worst);
    CHECK(worst <= 0.1);
}
