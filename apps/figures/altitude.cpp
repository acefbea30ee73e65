// The sky darkens as the eye climbs, but for the horizon. [Nielsen2003, fig. 7.3]

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "atmosphere/presets.h"
#include "physics/f64.h"
#include "sheet.h"

namespace airlight::figures {

namespace {

constexpr double sun_zenith = 45.0 * deg;

struct Both {
    ShownSky exact, nielsen;
};

Result<Both> both_skies(const Settings& settings) {
    const Result<Atmosphere> air = preset("earth-clear");
    if (!air) return air.error();
    const Result<ShownSky> exact = shown_sky(settings, "tables", *air, settings.bake.orders);
    if (!exact) return exact.error();
    const Result<ShownSky> nielsen = shown_sky(settings, "nielsen2003", *air, settings.bake.orders);
    if (!nielsen) return nielsen.error();
    return Both{*exact, *nielsen};
}

// A model that does not answer leaves the cell empty.
double luminance_or_none(const ShownSky& sky, const View& view) {
    const Result<double> seen = luminance(sky, view);
    return seen ? *seen : std::numeric_limits<double>::quiet_NaN();
}

constexpr double low = 88.0 * deg;

// Zenith angle of half a degree above the horizon that is seen, which dips as the eye climbs.
double above_horizon(Length altitude) {
    return std::acos(f64::horizon_cosine(f64::Length::of(altitude.in(m)), f64::Length::of(6371e3)).value) - 0.5 * deg;
}

// From just below the horizontal to the zenith, at a right angle to the sun.
Shot shot_at(Length altitude) {
    return {.name = fmt::format("eye at {:g} km", altitude.in(km)),
            .scene = {.altitude = altitude, .sun_zenith = sun_zenith, .sun_azimuth = 0.0},
            .camera = {.width = 1, .height = 1, .heading = 90.0 * deg, .pitch = 35.0 * deg, .vertical_field_of_view = 90.0 * deg},
            .ev100 = 13.2,
            .probe_zenith = 0.0,
            .probe_azimuth = 90.0 * deg};
}

}  // namespace

Result<Table> sky_by_altitude(const Settings& settings) {
    const Result<Both> skies = both_skies(settings);
    if (!skies) return skies.error();
    Table table{{"altitude_km", "zenith_cd_m2", "low_cd_m2", "horizon_cd_m2", "nielsen_zenith_cd_m2", "nielsen_low_cd_m2"}, {}};
    const int points = (settings.points - 1) / 4 + 1;
    for (int i = 0; i < points; ++i) {
        const Length h = 60.0 * static_cast<double>(i) / (points - 1) * km;
        std::vector<double> row = {h.in(km)};
        for (const double zenith : {0.0, low, above_horizon(h)})
            row.push_back(luminance_or_none(skies->exact, {h, zenith, sun_zenith, 90.0 * deg}));
        for (const double zenith : {0.0, low}) row.push_back(luminance_or_none(skies->nielsen, {h, zenith, sun_zenith, 90.0 * deg}));
        table.rows.push_back({{}, std::move(row)});
    }
    return table;
}

Result<Table> sky_from_altitudes(const Settings& settings) {
    const Result<Both> skies = both_skies(settings);
    if (!skies) return skies.error();
    return sheet(settings, "sky_from_altitudes", {shot_at(0.0 * km), shot_at(16.0 * km), shot_at(30.0 * km)},
                 {{"all orders", skies->exact}, {"nielsen2003", skies->nielsen}});
}

}  // namespace airlight::figures
