// What tests of the air's pictures share: a small picture, air that is quickly baked, cameras and suns over it, and views as the CPU knows
// them.
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "atmosphere/presets.h"
#include "camera/camera.h"
#include "models/airlight_tables.h"
#include "models/model.h"
#include "render/air_pass.h"
#include "tools/must.h"
#include "tools/temporary_folder.h"

namespace airlight::test {

inline constexpr int width = 15, height = 10;
// Five wavelengths are two groups of four; three of them are the three channels.
inline const std::vector<Wavelength> wavelengths = {450.0 * nm, 500.0 * nm, 550.0 * nm, 600.0 * nm, 650.0 * nm};
inline const std::vector<Vec3> colours = {{0, 0, 1}, {0, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}};
inline constexpr std::array<std::size_t, 3> wavelength_of_channel = {4, 2, 0};
inline const BakeSettings quick = {
    .sizes = {.transmittance_mu = 64, .transmittance_altitude = 32, .sun = 24, .azimuth = 4, .view = 8, .altitude = 12}, .orders = 2};

// What both are asked about, and the CPU's answers.
struct Truth {
    Atmosphere atmosphere = *preset("earth-clear");
    TemporaryFolder cache;
    Tables baked = *cached_tables(atmosphere, wavelengths, quick, {.folder = cache.path}, {});
    AirlightTables tables = airlight_tables(baked.packs()[0], 12);
    std::unique_ptr<Sky> sky = *make_sky("airlight", atmosphere, wavelengths, {.bake = quick, .cache = {.folder = cache.path}});
    double bottom_m() const { return atmosphere.bottom_radius.in(m); }
    render::AirPass pass(std::unique_ptr<render::AirMethod> method) const {
        return must(render::AirPass::create({atmosphere, wavelengths, colours}, std::move(method)));
    }
};

inline Camera camera_above(const Truth& model, double altitude_m, double pitch_deg) {
    Camera camera = look(Viewpoint{.latitude = 0.7, .longitude = 0.2, .altitude_m = altitude_m, .heading = 0.5, .pitch = pitch_deg * deg},
                         model.bottom_m());
    camera.width = width, camera.height = height;
    return camera;
}

inline Vec3 sun_at(const Truth& model, double zenith_deg) {
    return look(Viewpoint{.latitude = 0.7, .longitude = 0.2, .heading = 2.5, .pitch = (90.0 - zenith_deg) * deg}, model.bottom_m()).forward;
}

inline double angle_between(Vec3 a, Vec3 b) { return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)); }

// The view of a direction from a place, the sun towards `sun`.
inline View view_of(Vec3 from, double bottom_m, Vec3 direction, Vec3 sun) {
    const Vec3 up = glm::normalize(from);
    const Vec3 level = direction - glm::dot(direction, up) * up, sun_level = sun - glm::dot(sun, up) * up;
    return {(glm::length(from) - bottom_m) * m, angle_between(direction, up), angle_between(sun, up), angle_between(level, sun_level)};
}

// The mean difference over the mean of what was expected.
class MeanError {
public:
    void add(double seen, double expected) {
        difference_ += std::abs(seen - expected);
        sum_ += expected;
    }
    double value() const { return difference_ / sum_; }

private:
    double difference_ = 0.0, sum_ = 0.0;
};

// Of a picture from what is expected of each pixel's direction: a value for each wavelength, or none where nothing is.
template <class Pixels, class Expected>
double mean_error(const Pixels& pixels, const Camera& camera, const Expected& expected) {
    MeanError error;
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const std::vector<double> exact =
                expected(direction_at(camera, (column + 0.5) / width * 2.0 - 1.0, (row + 0.5) / height * 2.0 - 1.0));
            if (exact.empty()) continue;
            for (std::size_t c = 0; c < 3; ++c)
                error.add(static_cast<double>(pixels[static_cast<std::size_t>(4 * (row * width + column)) + c]),
                          exact[wavelength_of_channel[c]]);
        }
    return error.value();
}

}  // namespace airlight::test
