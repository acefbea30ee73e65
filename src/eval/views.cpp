#include "eval/views.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "image/exposure.h"
#include "image/projection.h"

namespace airlight {

namespace {

// Where the sun stands at 45 degrees north on the day of equinox, an angle of the hour after noon.
PictureView view_at(std::string_view title, double hour_angle, bool towards_sun) {
    const double latitude = 45.0 * deg;
    const double east = -std::sin(hour_angle), north = -std::sin(latitude) * std::cos(hour_angle),
                 up = std::cos(latitude) * std::cos(hour_angle);
    const SkyAngles sun = sky_angles({east, north, up});
    // At sunrise and sunset rounding must not put the sun below the horizon, where many models end.
    return {title, std::min(sun.zenith, 0.5 * pi), sun.azimuth, towards_sun};
}

Projection projection_of(const PictureView& view, int size) {
    if (!view.towards_sun) return Fisheye{size, size};
    const double elevation = 0.5 * pi - view.sun_zenith;
    return Perspective{size, size * 3 / 4, view.sun_azimuth, std::max(elevation, 12.0 * deg), 0.0, 40.0 * deg};
}

}  // namespace

std::array<PictureView, 5> picture_views() {
    return {view_at("sky at sunrise", -90.0 * deg, false), view_at("sky at noon", 0.0, false), view_at("sky at sunset", 90.0 * deg, false),
            view_at("sun at sunset", 90.0 * deg, true), view_at("sun at 16 h", 60.0 * deg, true)};
}

Result<Image> picture(const Sky& sky, const Sun& sun, const PictureView& view, Length altitude, int size, const PictureTools& tools) {
    const SkyScene scene{.altitude = altitude,
                         .sun_zenith = view.sun_zenith,
                         .sun_azimuth = view.sun_azimuth,
                         .sunlight = 1.0,
                         .sun_disk = view.towards_sun};
    return sky_image(sky, sun, scene, projection_of(view, size), tools.weights, tools.converter);
}

double picture_exposure(const Image& image, const RgbConverter& converter) {
    std::vector<float> luminance;
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < image.width; ++column) {
            const std::span<const float> rgb = image.pixel(column, row);
            luminance.push_back(static_cast<float>(std::max(0.0, converter.luminance({rgb[0], rgb[1], rgb[2]}))));
        }
    const Result<double> exposure = metered_exposure(luminance, {}, {.grey = 0.4});
    return exposure ? *exposure : 1.0;
}

MapGrid map_grid(const Atmosphere& atmosphere, const Condition& condition, int size) {
    const bool space = condition.altitude > atmosphere.top_altitude;
    MapGrid grid{size, space ? size / 2 : size, {}};
    const double horizon = horizon_zenith(atmosphere.bottom_radius, condition.altitude);
    const double top = horizon_zenith(atmosphere.bottom_radius + atmosphere.top_altitude, condition.altitude - atmosphere.top_altitude);
    const Projection fisheye = Fisheye{size, size, Fisheye::Law::equidistant, 2.0 * std::min(horizon, pi)};
    for (int row = 0; row < grid.height; ++row)
        for (int column = 0; column < grid.width; ++column) {
            const double x = (column + 0.5) / grid.width, y = (row + 0.5) / grid.height;
            if (space) {
                grid.directions.push_back(Direction{top + y * (horizon + 5.0 * deg - top), x * pi});
                continue;
            }
            const std::optional<Vec3> seen = direction(fisheye, {column + 0.5, row + 0.5});
            grid.directions.emplace_back();
            if (seen) grid.directions.back() = Direction{sky_angles(*seen).zenith, sky_angles(*seen).azimuth};
        }
    return grid;
}

ProfileGrid profile_grid(const Atmosphere& atmosphere, const Condition& condition) {
    const double horizon = horizon_zenith(atmosphere.bottom_radius, condition.altitude);
    ProfileGrid grid;
    if (condition.altitude > atmosphere.top_altitude) {
        const double top = horizon_zenith(atmosphere.bottom_radius + atmosphere.top_altitude, condition.altitude - atmosphere.top_altitude);
        grid.axis = "degrees above the horizon, towards the sun";
        for (int i = 0; i <= 72; ++i) {
            const double zenith = horizon + 3.0 * deg - i / 72.0 * (horizon + 3.0 * deg - top);
            grid.at.push_back((horizon - zenith) / deg);
            grid.directions.push_back({zenith, 0.0});
        }
        return grid;
    }
    grid.axis = "degrees from the zenith, towards the sun";
    // Denser towards both horizons; no direction is the zenith or the horizon itself.
    for (int i = 0; i < 72; ++i) {
        const double angle = horizon * std::sin((i + 0.5 - 36.0) / 36.0 * 0.5 * pi);
        grid.at.push_back(angle / deg);
        grid.directions.push_back({std::abs(angle), angle < 0.0 ? pi : 0.0});
    }
    return grid;
}

std::vector<double> luminances(const SkyDome& dome, std::size_t wavelengths, std::span<const Direction> directions,
                               const ColourWeights& weights) {
    std::vector<double> result(directions.size());
    constexpr std::size_t batch = 64;
    parallel_for((directions.size() + batch - 1) / batch, [&](std::size_t b) {
        const std::span<const Direction> asked = directions.subspan(b * batch, std::min(batch, directions.size() - b * batch));
        std::vector<float> radiance(asked.size() * wavelengths);
        dome.radiances(asked, radiance);
        for (std::size_t i = 0; i < asked.size(); ++i)
            result[b * batch + i] = std::max(0.0, weights.to_xyz(std::span<const float>(radiance).subspan(i * wavelengths, wavelengths)).y);
    });
    return result;
}

}  // namespace airlight
