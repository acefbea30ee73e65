// `airlight sun`: where the sun and the moon stand, and when the sun rises and sets.

#include <fmt/format.h>

#include <memory>

#include "command.h"
#include "sun/position.h"

namespace airlight::cli {

namespace {

struct SunOptions {
    double latitude_deg = 0.0;
    double longitude_deg = 0.0;
    double altitude_m = 0.0;
    std::string time;
    bool refraction = false;
    RefractionAir air;
    bool moon = false;
};

struct Question {
    Place place;
    Utc time;
    SkyOptions options;
};

Result<Question> question(const SunOptions& given) {
    const Result<Place> place = place_of({given.latitude_deg * deg, given.longitude_deg * deg, given.altitude_m * m});
    if (!place) return place.error();
    const Result<Utc> time = parse_utc(given.time);
    if (!time) return at("--time", time.error());
    const Result<RefractionAir> air = refraction_air_of(given.air);
    if (!air) return air.error();
    Question question{*place, *time, {}};
    if (given.refraction) question.options.refraction = *air;
    return question;
}

void print_position(const Question& q, bool moon) {
    const SunPosition sun = sun_position(q.place, q.time, q.options);
    fmt::print("body,time_utc,zenith_deg,azimuth_deg,distance_au,angular_radius_deg,illuminated_fraction\n");
    const auto row = [&](const char* body, const HorizontalDirection& d, double au, double radius, double lit) {
        fmt::print("{},{},{:.5f},{:.5f},{:.8f},{:.5f},{:.4f}\n", body, utc_text(q.time), d.zenith / deg, d.azimuth / deg, au, radius / deg, lit);
    };
    row("sun", sun.direction, sun.distance_au, sun.angular_radius, 1.0);
    if (!moon) return;
    const MoonPosition luna = moon_position(q.place, q.time, q.options);
    row("moon", luna.direction, luna.distance.in(m) / 149597870700.0, luna.angular_radius, luna.illuminated_fraction);
}

Result<Done> run(const SunOptions& given) {
    const Result<Question> q = question(given);
    if (!q) return q.error();
    print_position(*q, given.moon);
    return Done{};
}

}  // namespace

Command sun_command(CLI::App& airlight) {
    const auto given = std::make_shared<SunOptions>();
    CLI::App* sun = airlight.add_subcommand("sun", "Print where the sun stands in the sky of a place at a time.");
    sun->add_option("--lat", given->latitude_deg, "geodetic latitude, north positive, -90 to 90")->option_text("<deg>")->required();
    sun->add_option("--lon", given->longitude_deg, "longitude, east positive, -180 to 180")->option_text("<deg>")->required();
    sun->add_option("--time", given->time, "ISO 8601, years 1900 to 2100; UTC unless it ends in an offset (-07:00)")->option_text("<time>")->required();
    sun->add_option("--altitude-m", given->altitude_m, "height above sea level, -500 to 1000000")->option_text("<m>")->capture_default_str();
    sun->add_flag("--refraction", given->refraction, "bend the light in air; without it, directions are straight lines");
    sun->add_option("--pressure-hpa", given->air.pressure_hpa, "air pressure at the eye, 0 to 1100")->option_text("<hPa>")->capture_default_str();
    sun->add_option("--temperature-c", given->air.temperature_c, "air temperature at the eye, -100 to 60")->option_text("<deg C>")->capture_default_str();
    sun->add_flag("--moon", given->moon, "a second row for the moon");
    sun->footer(help_footer(
        "CSV, one row a body: body, time_utc, zenith_deg (0 is straight up), azimuth_deg (from north, clockwise),\n"
        "        distance_au (from the eye), angular_radius_deg, illuminated_fraction",
        "airlight sun --lat 39.74 --lon -105.18 --time 2003-10-17T19:30:30Z"));
    return {sun, [given] { return run(*given); }};
}

}  // namespace airlight::cli
