// `airlight sun`: where the sun and the moon stand, and when the sun rises and sets.

#include <fmt/format.h>

#include <memory>

#include "command.h"
#include "sun/events.h"

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
    bool events = false;
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
        fmt::print("{},{},{:.5f},{:.5f},{:.8f},{:.5f},{:.4f}\n", body, utc_text(q.time), d.zenith / deg, d.azimuth / deg, au, radius / deg,
                   lit);
    };
    row("sun", sun.direction, sun.distance_au, sun.angular_radius, 1.0);
    if (!moon) return;
    const MoonPosition luna = moon_position(q.place, q.time, q.options);
    row("moon", luna.direction, luna.distance.in(m) / 149597870700.0, luna.angular_radius, luna.illuminated_fraction);
}

// Seconds are rounded: an event is not known better.
void print_event(const std::string& event, const Utc& time) {
    fmt::print("{},{}\n", event, utc_text(after(time, 0.5) ? *after(time, 0.5) : time));
}

void print_crossings(const Crossings& crossings, const std::string& body, const char* rise, const char* set) {
    for (const Utc& time : crossings.rises) print_event(rise, time);
    for (const Utc& time : crossings.sets) print_event(set, time);
    if (crossings.always_above()) fmt::print("{}_always_above,\n", body);
    if (crossings.always_below()) fmt::print("{}_always_below,\n", body);
}

void print_events(const Question& q, bool moon) {
    const SunDay day = sun_day(q.place, q.time);
    fmt::print("event,time_utc\n");
    print_crossings(day.astronomical, "astronomical_twilight", "astronomical_dawn", "astronomical_dusk");
    print_crossings(day.nautical, "nautical_twilight", "nautical_dawn", "nautical_dusk");
    print_crossings(day.civil, "civil_twilight", "civil_dawn", "civil_dusk");
    print_crossings(day.sun, "sun", "sunrise", "sunset");
    print_event("sun_highest", day.highest);
    if (moon) print_crossings(moon_rises_and_sets(q.place, q.time), "moon", "moonrise", "moonset");
}

Result<Done> run(const SunOptions& given) {
    const Result<Question> q = question(given);
    if (!q) return q.error();
    if (given.events) print_events(*q, given.moon);
    else print_position(*q, given.moon);
    return Done{};
}

}  // namespace

Command sun_command(CLI::App& airlight) {
    const auto given = std::make_shared<SunOptions>();
    CLI::App* sun = airlight.add_subcommand("sun", "Print where the sun stands in the sky of a place at a time.");
    sun->add_option("--lat", given->latitude_deg, "geodetic latitude, north positive, -90 to 90")->option_text("<deg>")->required();
    sun->add_option("--lon", given->longitude_deg, "longitude, east positive, -180 to 180")->option_text("<deg>")->required();
    sun->add_option("--time", given->time, "ISO 8601, years 1900 to 2100; UTC unless it ends in an offset (-07:00)")
        ->option_text("<time>")
        ->required();
    sun->add_option("--altitude-m", given->altitude_m, "height above sea level, -500 to 1000000")
        ->option_text("<m>")
        ->capture_default_str();
    sun->add_flag("--refraction", given->refraction, "bend the light in air; without it, directions are straight lines");
    sun->add_option("--pressure-hpa", given->air.pressure_hpa, "air pressure at the eye, 0 to 1100")
        ->option_text("<hPa>")
        ->capture_default_str();
    sun->add_option("--temperature-c", given->air.temperature_c, "air temperature at the eye, -100 to 60")
        ->option_text("<deg C>")
        ->capture_default_str();
    sun->add_flag("--moon", given->moon, "the moon, too");
    sun->add_flag("--events", given->events, "print instead when the sun rises and sets in the UTC day of --time");
    sun->footer(
        help_footer("CSV, one row a body: body, time_utc, zenith_deg (0 is straight up), azimuth_deg (from north, clockwise),\n"
                    "        distance_au (from the eye), angular_radius_deg, illuminated_fraction\n"
                    "        with --events, one row an event: event, time_utc; sunrise and sunset are the upper limb's (zenith "
                    "90.833 deg),\n"
                    "        dawn and dusk the centre's at zenith 96 (civil), 102 (nautical) and 108 deg (astronomical);\n"
                    "        sun_always_above or _below, with no time, where none happens\n"
                    "        UT1 - UTC is taken as 0 (below 0.004 deg); leap seconds are ERFA's",
                    "airlight sun --lat 39.74 --lon -105.18 --time 2003-10-17T19:30:30Z"));
    return {sun, [given] { return run(*given); }};
}

}  // namespace airlight::cli
