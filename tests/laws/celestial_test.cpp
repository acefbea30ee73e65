// Eclipses, the moon's light, the stars and refraction: laws, and published figures.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "atmosphere/presets.h"
#include "celestial/eclipse.h"
#include "celestial/moonlight.h"
#include "celestial/night_sky.h"
#include "celestial/refraction.h"
#include "celestial/stars.h"
#include "core/quadrature.h"
#include "sun/position.h"

using namespace airlight;

namespace {

double left(double d, double sun, double moon, double dark_1, double dark_2) {
    return sunlight_left(covered_sun(d, sun, moon), dark_1, dark_2);
}

// Of a unit sun, ring by ring: the part of each ring that the moon leaves free is an arc.
double left_by_rings(double d, double moon, double dark_1, double dark_2) {
    constexpr int rings = 20000;
    double free = 0.0, all = 0.0;
    for (int i = 0; i < rings; ++i) {
        const double s = (i + 0.5) / rings, mu = std::sqrt(1.0 - s * s);
        const double light = s * (1.0 - dark_1 * (1.0 - mu) - dark_2 * (1.0 - mu) * (1.0 - mu));
        const double cosine = (s * s + d * d - moon * moon) / (2.0 * s * d);
        all += light;
        free += light * (1.0 - std::acos(std::clamp(cosine, -1.0, 1.0)) / pi);
    }
    return free / all;
}

Utc time_of(const std::string& text) { return *parse_utc(text); }

struct Eclipse {
    double separation, sun, moon;
    double magnitude() const { return (sun + moon - separation) / (2.0 * sun); }
    double obscuration() const { return disks_in_common(sun, moon, separation) / (pi * sun * sun); }
    bool total() const { return separation + sun <= moon; }
};

Eclipse eclipse_at(double latitude_deg, double longitude_deg, const Utc& moment) {
    const Place place = *place_of({latitude_deg * deg, longitude_deg * deg, 0.0 * m});
    const SunPosition sun = sun_position(place, moment);
    const MoonPosition moon = moon_position(place, moment);
    const Vec3 a = east_north_up(sun.direction), b = east_north_up(moon.direction);
    return {std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)), sun.angular_radius, moon.angular_radius};
}

}  // namespace

TEST_CASE("two disks have nothing, the smaller one or a lens in common, whichever is named first") {
    CHECK(disks_in_common(1.0, 2.0, 3.1) == 0.0);
    CHECK(disks_in_common(1.0, 2.0, 0.9) == doctest::Approx(pi));
    CHECK(disks_in_common(3.0, 0.5, 1.0) == doctest::Approx(0.25 * pi));
    // Of unit disks at distance d: 2 acos(d / 2) - d / 2 sqrt(4 - d^2).
    for (double d = 0.01; d < 2.0; d += 0.07)
        CHECK(disks_in_common(1.0, 1.0, d) == doctest::Approx(2.0 * std::acos(0.5 * d) - 0.5 * d * std::sqrt(4.0 - d * d)).epsilon(1e-12));
    for (double d = 0.3; d < 1.7; d += 0.1)
        CHECK(disks_in_common(0.7, 1.0, d) == doctest::Approx(disks_in_common(1.0, 0.7, d)).epsilon(1e-14));
}

TEST_CASE("what the moon leaves of a darkened sun is what rings of the sun say, within 0.01 % of the whole") {
    double uniform = 0.0, darkened = 0.0;
    for (const double moon : {0.3, 0.95, 1.05})
        for (double d = 0.005; d < 1.0 + moon; d += 0.0217) {
            uniform = std::max(uniform, std::abs(left(d, 1.0, moon, 0.0, 0.0) - left_by_rings(d, moon, 0.0, 0.0)));
            darkened = std::max(darkened, std::abs(left(d, 1.0, moon, 0.47, 0.23) - left_by_rings(d, moon, 0.47, 0.23)));
        }
    fmt::print("  of the sun's light, at most: uniform {:.1e}, darkened {:.1e}\n", uniform, darkened);
    CHECK(uniform < 2e-6);
    CHECK(darkened < 1e-4);
    CHECK(left(0.0, 1.0, 1.02, 0.47, 0.23) < 1e-15);
    CHECK(left(2.1, 1.0, 1.02, 0.47, 0.23) == 1.0);
    CHECK(left(0.3, 1.0, 0.0, 0.47, 0.23) == doctest::Approx(1.0));
}

// [NASA2024]: totality, to the minute and for the city (a few kilometres, some seconds): its begin, its middle, where the sun
// must be covered, and its end. UT1 - UTC was 0.
TEST_CASE("the eclipse of 8 April 2024 was total in the cities and minutes that NASA announced") {
    struct City {
        const char* name;
        double latitude, longitude;
        const char *begin, *end;
    };
    for (const City& city : {City{"Dallas", 32.78, -96.80, "18:40", "18:44"},
                             {"Little Rock", 34.75, -92.29, "18:51", "18:54"},
                             {"Carbondale", 37.73, -89.22, "18:59", "19:03"},
                             {"Cleveland", 41.50, -81.69, "19:13", "19:17"},
                             {"Erie", 42.13, -80.09, "19:16", "19:20"},
                             {"Buffalo", 42.89, -78.88, "19:18", "19:22"},
                             {"Burlington", 44.48, -73.21, "19:26", "19:29"},
                             {"Caribou", 46.86, -68.01, "19:32", "19:34"}}) {
        const auto clock = [](const char* text) { return time_of(fmt::format("2024-04-08T{}:00Z", text)); };
        // Minutes are cut, not rounded: the true ones lie within the minute that follows, and ten seconds for the place in the city.
        const auto total = [&](const Utc& moment) { return eclipse_at(city.latitude, city.longitude, moment).total(); };
        double first = 0.0, last = 0.0;
        for (double t = -120.0; t < 480.0; t += 1.0)
            if (total(*after(clock(city.begin), t))) {
                if (last == 0.0) first = t;
                last = t;
            }
        const double end = seconds_between(clock(city.begin), clock(city.end));
        CAPTURE(city.name);
        fmt::print("  {:<12} total from {:+.0f} s to {:+.0f} s of the minutes announced\n", city.name, first, last - end);
        CHECK(first >= -30.0);
        CHECK(first <= 75.0);
        CHECK(last - end >= -30.0);
        CHECK(last - end <= 75.0);
    }
}

// [NationalEclipse2024], maxima to a second and obscurations to 0.1 %.
TEST_CASE("the eclipse of 8 April 2024 covered as much of the sun over cities beside its path as was published") {
    struct City {
        double latitude, longitude;
        const char* greatest;
        double percent;
    };
    for (const City& city : {City{21.31, -157.86, "17:13:01", 17.7},
                             {32.72, -117.16, "18:11:25", 53.9},
                             {34.05, -118.24, "18:12:20", 48.9},
                             {37.77, -122.42, "18:13:24", 34.0},
                             {33.45, -112.07, "18:20:01", 64.0},
                             {45.52, -122.68, "18:25:50", 22.2},
                             {47.61, -122.33, "18:29:22", 20.0},
                             {35.08, -106.65, "18:30:51", 73.0},
                             {27.51, -99.51, "18:29:14", 98.0}}) {
        const Eclipse e = eclipse_at(city.latitude, city.longitude, time_of(fmt::format("2024-04-08T{}Z", city.greatest)));
        CAPTURE(city.greatest);
        CHECK(std::abs(100.0 * e.obscuration() - city.percent) < 0.3);
    }
}

// [EspenakMeeus2006]: greatest eclipse at 18:17:16 UT, 25.3 N 104.1 W, and at 11:03:07 UT, 45.1 N 24.3 E.
TEST_CASE("at greatest eclipse the moon's disk was as much larger than the sun's as the canon says") {
    CHECK(std::abs(eclipse_at(25.29, -104.14, time_of("2024-04-08T18:17:18Z")).moon /
                       eclipse_at(25.29, -104.14, time_of("2024-04-08T18:17:18Z")).sun -
                   1.0566) < 0.002);
    CHECK(std::abs(eclipse_at(45.08, 24.29, time_of("1999-08-11T11:03:05Z")).moon /
                       eclipse_at(45.08, 24.29, time_of("1999-08-11T11:03:05Z")).sun -
                   1.0286) < 0.002);
}

TEST_CASE("a ball by Lommel and Seeliger's law is as bright at each phase as the closed form says") {
    for (const double a : {0.0, 0.3, 1.0, 2.0, 2.8}) {
        // Over the disk, in the plane of sun and eye: the normal is at longitude l from the eye and latitude b.
        double sum = 0.0;
        const GaussRule longitudes = gauss_rule(64, a - 0.5 * pi, 0.5 * pi), latitudes = gauss_rule(64, -0.5 * pi, 0.5 * pi);
        for (std::size_t i = 0; i < longitudes.nodes.size(); ++i)
            for (std::size_t k = 0; k < latitudes.nodes.size(); ++k) {
                const double cb = std::cos(latitudes.nodes[k]), mu = cb * std::cos(longitudes.nodes[i]);
                const double mu_0 = cb * std::cos(longitudes.nodes[i] - a);
                if (mu + mu_0 > 0.0) sum += longitudes.weights[i] * latitudes.weights[k] * cb * mu * 2.0 * mu_0 / (mu + mu_0);
            }
        CHECK(lommel_seeliger_brightness(a) == doctest::Approx(sum / pi).epsilon(1e-5));
    }
}

TEST_CASE("the full moon is of magnitude -12.73 beside a sun of -26.74, and half of it an eleventh as bright") {
    const double share = moonlight_share(0.0, moon_mean_distance).at(550.0 * nm).value / moon_brightness(0.0);
    CHECK(std::abs(-26.74 - 2.5 * std::log10(share) + 12.73) < 0.01);
    // Above the air 0.31 lux; a fifth of it is lost on the way to the ground.
    CHECK(share * 127e3 == doctest::Approx(0.31).epsilon(0.05));
    CHECK(moon_brightness(90.0 * deg) == doctest::Approx(1.0 / 11.0).epsilon(0.02));
    CHECK(moon_brightness(3.0 * deg) > moon_brightness(7.0 * deg) * 1.2);
    // What the disk's law and its area make is what the share says.
    CHECK(moonlight_share(1.0, moon_mean_distance).at(550.0 * nm).value == doctest::Approx(share * moon_brightness(1.0)).epsilon(1e-9));
}

// [Seidelmann1992, eq. 9.3]: log10 of lux falls by 0.00868 a degree and 2.2e-9 a^4. An older law: they differ by up to 40 %.
TEST_CASE("moonlight falls with its phase as in the almanac's formula") {
    for (const double a : {20.0, 40.0, 60.0, 80.0, 100.0, 120.0}) {
        const double almanac = std::pow(10.0, -0.00868 * a - 2.2e-9 * a * a * a * a);
        const double ratio = moon_brightness(a * deg) / almanac;
        CHECK(ratio > 0.6);
        CHECK(ratio < 1.05);
    }
}

TEST_CASE("the dark side of a young moon is some ten thousand times darker than the lit one") {
    const double dark = earthshine_share(170.0 * deg, moon_mean_distance).at(550.0 * nm).value;
    const double lit = moon_radiance_factor(0.0) / moon_brightness(0.0);  // of a full moon
    CHECK(dark / lit > 4e-5);
    CHECK(dark / lit < 1e-4);
    CHECK(earthshine_share(0.0, moon_mean_distance).at(550.0 * nm).value == doctest::Approx(0.0).epsilon(1e-12));
    CHECK(earthshine_share(2.0, moon_mean_distance).at(450.0 * nm) > earthshine_share(2.0, moon_mean_distance).at(600.0 * nm));
}

TEST_CASE("stars stand where sidereal time puts them, shine by their magnitudes and have their colours") {
    const std::vector<Star> stars = stars_at(time_of("2000-01-01T12:00:00Z"), 6.0);
    CHECK(stars.size() > 5000);
    CHECK(stars_at(time_of("2000-01-01T12:00:00Z"), 1.5).size() == 23);  // the stars of first magnitude: 1.5 rounds to it
    // Greenwich's mean sidereal time then: 280.461 deg [Meeus1998, eq. 12.4]; Sirius at 101.287, -16.716 deg.
    const Vec3 sirius = stars[0].direction;
    CHECK(std::abs(std::asin(sirius.z) / deg + 16.716) < 0.01);
    CHECK(std::abs(std::remainder(std::atan2(sirius.y, sirius.x) / deg - (101.287 - 280.461), 360.0)) < 0.01);
    CHECK(stars[0].illuminance.y == doctest::Approx(2.54e-6 * std::pow(10.0, 0.4 * 1.44)));
    CHECK(stars[2].illuminance.x / stars[2].illuminance.z > 1.5 * stars[0].illuminance.x / stars[0].illuminance.z);  // Arcturus is red
    CHECK(temperature_of_colour_index(0.65) == doctest::Approx(5778.0).epsilon(0.01));                               // the sun
    // All of them give a thousandth of the full moon's light.
    double all = 0.0;
    for (const Star& star : stars) all += star.illuminance.y;
    CHECK(all > 1e-4);
    CHECK(all < 1e-3);
}

TEST_CASE("air bends rays as Saemundsson's formula says, down to the horizon") {
    const Atmosphere air = *preset("earth-clear");
    const RefractionAir ground{1013.25, 15.0};
    for (const double true_deg : {-0.55, 0.0, 0.5, 1.0, 2.0, 5.0, 15.0, 45.0}) {
        const double apparent = 0.5 * pi - refracted_zenith((90.0 - true_deg) * deg, ground);
        const double found = bending(air, 0.0 * m, apparent), expected = apparent - true_deg * deg;
        fmt::print("  apparent {:6.3f} deg: {:6.3f}', by the formula {:6.3f}'\n", apparent / deg, found / deg * 60.0,
                   expected / deg * 60.0);
        // The formula is good to 0.17', and the horizon's rays know the layering of the lowest air, which was another's.
        CHECK(std::abs(found - expected) / deg * 60.0 < std::max(0.03 * expected / deg * 60.0, 0.17));
    }
}

TEST_CASE("high in the sky bending is (n - 1) tan z, from space the limb bends twice as much as the horizon, without air nothing bends") {
    const Atmosphere air = *preset("earth-rayleigh");
    CHECK(bending(air, 0.0 * m, 60.0 * deg) == doctest::Approx(2.78e-4 * std::tan(30.0 * deg)).epsilon(0.01));
    CHECK(bending(air, 0.0 * m, 90.0 * deg) == doctest::Approx(0.0).epsilon(1e-9));
    const double horizon = bending(air, 0.0 * m, 0.0);
    CHECK(bending(air, 400.0 * km, apparent_horizon(air, 400.0 * km)) == doctest::Approx(2.0 * horizon).epsilon(0.005));
    CHECK(bending(air, 400.0 * km, 10.0 * deg) == 0.0);
    Atmosphere none = air;
    none.constituents.clear();
    CHECK(bending(none, 0.0 * m, 0.1) == 0.0);
    CHECK(apparent_horizon(none, 400.0 * km) == doctest::Approx(-std::acos((air.bottom_radius / (air.bottom_radius + 400.0 * km)).value)));
}

TEST_CASE("a table of bending is even in the fourth root of the elevation above the horizon") {
    const Atmosphere air = *preset("earth-clear");
    const BendingTable table = bending_table(air, 2.0 * km, 96);
    REQUIRE(table.bending.size() == 96);
    CHECK(table.horizon == doctest::Approx(apparent_horizon(air, 2.0 * km)));
    CHECK(table.horizon < 0.0);
    // Linear between its places: within 5" anywhere, of a sun of 1900".
    for (double e = table.horizon + 1e-4; e < 1.5; e += 0.003) {
        const double u = std::pow((e - table.horizon) / (0.5 * pi - table.horizon), 0.25) * 95.0;
        const auto k = static_cast<std::size_t>(u);
        const double linear = table.bending[k] + (u - static_cast<double>(k)) * (table.bending[k + 1] - table.bending[k]);
        CHECK(std::abs(linear - bending(air, 2.0 * km, e)) / deg * 3600.0 < 5.0);
    }
}

TEST_CASE("a sky without sun and moon is as dark as the darkest are, and light of the ground is that of all its directions") {
    const NightSky sky = night_sky();
    // In magnitudes of a square second of arc, of which dark sites have 21.5 to 22 at the zenith [BennEllison1998].
    const double square_second = deg * deg / (3600.0 * 3600.0);
    const double magnitude = -2.5 * std::log10((sky.beyond.y + sky.airglow.y) * square_second / lux_of_magnitude_0);
    fmt::print("  zenith {:.2f} mag arcsec-2, {:.2e} cd m-2\n", magnitude, sky.beyond.y + sky.airglow.y);
    CHECK(magnitude > 21.5);
    CHECK(magnitude < 22.0);
    CHECK(van_rhijn(0.0) == 1.0);
    CHECK(van_rhijn(0.5 * pi) == doctest::Approx(6.0).epsilon(0.02));  // [Leinert1998]
    const GaussRule zenith_angles = gauss_rule(64, 0.0, 0.5 * pi);
    double mean = 0.0, lux = 0.0;
    for (std::size_t i = 0; i < zenith_angles.nodes.size(); ++i) {
        const double z = zenith_angles.nodes[i], luminance = sky.beyond.y + sky.airglow.y * van_rhijn(z);
        mean += zenith_angles.weights[i] * std::sin(z) * luminance;
        lux += zenith_angles.weights[i] * 2.0 * pi * std::sin(z) * std::cos(z) * luminance;
    }
    CHECK(mean_luminance(sky).y == doctest::Approx(mean).epsilon(1e-6));
    CHECK(illuminance(sky).y == doctest::Approx(lux).epsilon(1e-6));
}
