// Where the sun and the moon stand: laws of the sphere, of the year and of refraction.

#include <doctest/doctest.h>
#include <erfa.h>

#include <random>

#include "sun/events.h"
#include "sun/position.h"
#include "sun/preetham1999.h"

using namespace airlight;

namespace {

Place at_degrees(double latitude, double longitude) { return *place_of({latitude * deg, longitude * deg, 0.0 * m}); }
Utc time_of(const char* text) { return *parse_utc(text); }

double separation(const HorizontalDirection& a, const HorizontalDirection& b) {
    const Vec3 u = east_north_up(a);
    const Vec3 v = east_north_up(b);
    return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

}  // namespace

TEST_CASE("a direction is a unit vector: east, north, up") {
    const auto is = [](Vec3 v, Vec3 w) { CHECK(glm::length(v - w) < 1e-15); };
    is(east_north_up({0.0, 90.0 * deg}), {0, 1, 0});
    is(east_north_up({90.0 * deg, 90.0 * deg}), {1, 0, 0});
    is(east_north_up({123.0 * deg, 0.0}), {0, 0, 1});
    is(east_north_up({225.0 * deg, 180.0 * deg}), {0, 0, -1});
}

TEST_CASE("the sun stands in the zenith of the Tropic of Cancer at noon of the June solstice") {
    // The solstice of 2020: 20 June 21:44 UTC, obliquity 23.4365 deg. Noon then is at (12 - 21.73) h * 15 = -146 deg.
    const SunDay day = sun_day(at_degrees(23.4365, -146.0), time_of("2020-06-20"));
    CHECK(day.highest_zenith / deg < 0.003);  // nutation in obliquity 0.0026 deg
    CHECK(std::abs(seconds_between(day.highest, time_of("2020-06-20T21:44Z"))) < 300.0);
}

TEST_CASE("at the equator the day lasts twelve hours and what refraction and the disk add") {
    for (const char* date : {"2023-03-20", "2023-09-23"}) {
        const SunDay day = sun_day(at_degrees(0.0, 0.0), time_of(date));
        REQUIRE(day.sun.rises.size() == 1);
        REQUIRE(day.sun.sets.size() == 1);
        // 2 * 90.833 deg at 15 deg/h; half a day changes the equation of time by at most 15 s.
        CHECK(std::abs(seconds_between(day.sun.rises[0], day.sun.sets[0]) - 2.0 * 90.833 * 240.0) < 15.0);
    }
}

TEST_CASE("morning and afternoon mirror each other about the meridian") {
    for (const double latitude : {-60.0, -35.0, 10.0, 52.0}) {
        // At a solstice the declination stands still: it moves by less than 0.0005 deg in six hours.
        const Place place = at_degrees(latitude, 20.0);
        const SunDay day = sun_day(place, time_of("2021-06-21"));
        REQUIRE(day.sun.rises.size() == 1);
        REQUIRE(day.sun.sets.size() == 1);
        const double rise = sun_position(place, day.sun.rises[0]).direction.azimuth;
        const double set = sun_position(place, day.sun.sets[0]).direction.azimuth;
        CHECK(std::abs((rise + set) / deg - 360.0) < 0.005);
    }
}

TEST_CASE("the equation of time runs from -14.3 to +16.5 minutes and is Meeus' in his example") {
    double least = 0.0;
    double most = 0.0;
    for (int day = 0; day < 365; ++day) {
        const double e = equation_of_time_s(*after(time_of("2019-01-01"), day * 86400.0));
        least = std::min(least, e);
        most = std::max(most, e);
    }
    CHECK(std::abs(least / 60.0 + 14.25) < 0.05);  // 11 February
    CHECK(std::abs(most / 60.0 - 16.45) < 0.05);   // 3 November
    // [Meeus1998, example 28.a]: 1992 October 13.0 TD, +13 min 42.6 s. His mean sun runs in TD, 59 s ahead of UT then: it
    // gains 59 s / 365.25 = 0.16 s on one that runs in UT; the last digit leaves 0.05 s.
    CHECK(std::abs(equation_of_time_s(time_of("1992-10-13T00:00Z")) - 822.6) < 0.16 + 0.06);
}

TEST_CASE("the sun is nearest in early January and farthest in early July") {
    const Place place = at_degrees(0.0, 0.0);
    // Perihelion and aphelion of 2020: January 5, 0.98324 au; July 4, 1.01669 au. The eye is up to an Earth radius nearer.
    const double parallax_au = 6378.0 / 149597870.7;
    CHECK(std::abs(sun_position(place, time_of("2020-01-05T08:00Z")).distance_au - 0.98324) < parallax_au + 5e-6);
    CHECK(std::abs(sun_position(place, time_of("2020-07-04T12:00Z")).distance_au - 1.01669) < parallax_au + 5e-6);
    CHECK(std::abs(sun_position(place, time_of("2020-01-05T08:00Z")).angular_radius / deg * 60.0 - 16.26) < 0.02);  // arcmin
}

TEST_CASE("polar day and polar night are answers") {
    const SunDay summer = sun_day(at_degrees(69.65, 18.96), time_of("2024-06-21"));
    CHECK(summer.sun.always_above());
    CHECK(summer.astronomical.always_above());
    const SunDay winter = sun_day(at_degrees(69.65, 18.96), time_of("2024-12-21"));
    CHECK(winter.sun.always_below());
    CHECK(winter.civil.rises.size() == 1);
    const SunDay pole = sun_day(at_degrees(-90.0, 0.0), time_of("2024-12-21"));
    CHECK(pole.sun.always_above());
    const SunDay north = sun_day(at_degrees(90.0, 0.0), time_of("2024-12-21"));
    CHECK(north.astronomical.always_below());
}

TEST_CASE("a sun that shows for minutes only, between two looks at it, is not missed") {
    // Northward into the polar night of 21 December the short day shrinks to nothing, without a jump.
    double previous = 3600.0;
    bool seen_short = false;
    for (double latitude = 67.0; latitude < 67.5; latitude += 0.005) {
        const SunDay day = sun_day(at_degrees(latitude, 18.0), time_of("2024-12-21"));
        REQUIRE(day.sun.rises.size() == day.sun.sets.size());
        if (day.sun.rises.empty()) break;
        const double length = seconds_between(day.sun.rises[0], day.sun.sets[0]);
        CHECK(length < previous + 3600.0);
        seen_short |= length < 1000.0;
        previous = length;
    }
    CHECK(seen_short);
}

TEST_CASE("at a rise or a set the body stands where the definition says") {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (int i = 0; i < 12; ++i) {
        const Place place = at_degrees(58.0 * uniform(random), 180.0 * uniform(random));
        const Utc date = *after(time_of("2000-01-01"), 43.0 * 365.25 * 86400.0 * (0.5 + 0.5 * uniform(random)));
        const SunDay day = sun_day(place, date);
        // The hour angle moves by 15 arcsec a second: 0.02 s is 1e-4 deg at most.
        for (const Utc& t : day.sun.rises) CHECK(std::abs(sun_position(place, t).direction.zenith / deg - 90.833) < 1e-4);
        for (const Utc& t : day.sun.sets) CHECK(std::abs(sun_position(place, t).direction.zenith / deg - 90.833) < 1e-4);
        // Below 60 deg the moon, never beyond 28.7 deg of declination, crosses every horizon once a day of 24.8 hours.
        const Crossings moon = moon_rises_and_sets(place, date);
        CHECK(moon.rises.size() + moon.sets.size() >= 1);
        for (const Utc& t : moon.rises) {
            const MoonPosition risen = moon_position(place, t);
            CHECK(std::abs((risen.direction.zenith - risen.angular_radius) / deg - 90.0 - 34.0 / 60.0) < 1e-4);
        }
    }
}

TEST_CASE("the moon keeps its distance, and its lit part follows its phase") {
    const Place place = at_degrees(-33.0, 151.0);
    for (int day = 0; day < 400; day += 7) {
        const MoonPosition moon = moon_position(place, *after(time_of("2022-03-01T10:00Z"), day * 86400.0));
        CHECK(moon.distance > 350000.0 * km);  // 356 400 km at the least from the centre, less the Earth's radius
        CHECK(moon.distance < 413100.0 * km);  // 406 700 km and the Earth's radius
        CHECK(moon.illuminated_fraction == doctest::Approx(0.5 * (1.0 + std::cos(moon.phase_angle))));
        CHECK(moon.angular_radius / deg == doctest::Approx(std::asin(1737.4 / moon.distance.in(km)) / deg));
    }
}

TEST_CASE("refraction lifts, keeps the order of the sky, vanishes in the zenith and is ERFA's down to 75 degrees") {
    const RefractionAir air{1005.0, 7.0};
    double refa = 0.0;
    double refb = 0.0;
    eraRefco(air.pressure_hpa, air.temperature_c, 0.5, 0.55, &refa, &refb);
    double previous = -1.0;
    for (double zenith = 0.0; zenith <= 180.0; zenith += 0.05) {
        const double seen = refracted_zenith(zenith * deg, air) / deg;
        CHECK(seen <= zenith + 1e-12);
        CHECK(seen >= previous);
        previous = seen;
        if (zenith > 75.0 || zenith < 1.0) continue;
        const double t = std::tan(seen * deg);
        const double lift_arcmin = (refa * t + refb * t * t * t) / deg * 60.0;
        CHECK(std::abs((zenith - seen) * 60.0 - lift_arcmin) < 0.1 + 0.07);  // his bound to Bennett's formula, and Bennett's to Garfinkel's
    }
    CHECK(refracted_zenith(60.0 * deg, {0.0, 7.0}) == 60.0 * deg);
    // The standard horizontal refraction, 34 arcmin, at the apparent horizon.
    CHECK(std::abs(refracted_zenith((90.0 + 34.0 / 60.0) * deg, {1010.0, 10.0}) / deg * 60.0 - 5400.0) < 1.0);
}

TEST_CASE("a place or an air that cannot be is refused with its range") {
    CHECK(place_of({95.0 * deg, 0.0, 0.0 * m}).error().message().find("latitude: 95 deg is out of range: it must be -90 to 90") == 0);
    CHECK(place_of({0.0, 181.0 * deg, 0.0 * m}).error().where == "longitude");
    CHECK(place_of({0.0, 0.0, 2000.0 * km}).error().where == "altitude");
    CHECK(!place_of({std::nan(""), 0.0, 0.0 * m}));
    CHECK(refraction_air_of({1200.0, 10.0}).error().where == "pressure");
    CHECK(refraction_air_of({1000.0, 90.0}).error().where == "temperature");
}

TEST_CASE("Preetham's formula stays within a degree of the sun, and its printed azimuth breaks Pythagoras") {
    double worst = 0.0;
    for (int hour = 0; hour < 365 * 24; hour += 5)
        for (const double latitude : {-70.0, -23.0, 0.0, 40.0, 65.0}) {
            const Place place = at_degrees(latitude, 15.0 * (hour % 24) - 170.0);
            const Utc t = *after(time_of("2023-01-01"), hour * 3600.0);
            worst = std::max(worst, separation(preetham1999_sun(place, t), sun_position(place, t).direction));
        }
    MESSAGE("Preetham 1999 against ERFA in 2023: worst separation " << worst / deg << " deg");
    CHECK(worst / deg < 1.0);

    // As printed: atan2(-cos d sin a, cos l sin d - sin l cos d cos a). With l = 40 deg, d = 20 deg and a = 150 deg the two
    // parts and the upward one must be a unit vector; only the sign that preetham1999_sun() uses makes them one.
    const double l = 40.0 * deg, d = 20.0 * deg, a = 150.0 * deg;
    const double up = std::sin(l) * std::sin(d) - std::cos(l) * std::cos(d) * std::cos(a);
    const double west = -std::cos(d) * std::sin(a);
    const double printed = std::cos(l) * std::sin(d) - std::sin(l) * std::cos(d) * std::cos(a);
    const double mended = -std::cos(l) * std::sin(d) - std::sin(l) * std::cos(d) * std::cos(a);
    CHECK(up * up + west * west + mended * mended == doctest::Approx(1.0).epsilon(1e-14));
    CHECK(std::abs(up * up + west * west + printed * printed - 1.0) > 0.3);
}
