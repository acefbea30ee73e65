#include "sun/position.h"

#include <erfa.h>
#include <erfam.h>
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sun/time_scales.h"

namespace airlight {

namespace {

constexpr double au_m = astronomical_unit.value;
constexpr double light_days_per_au = au_m / 299792458.0 / 86400.0;
constexpr double sun_radius_m = 695.7e6;  // IAU 2015 resolution B3, nominal

struct State {  // barycentric, GCRS axes, au and au per day
    Vec3 position;
    Vec3 velocity;
};

Vec3 vec3(const double v[3]) { return {v[0], v[1], v[2]}; }
State state(const double pv[2][3]) { return {vec3(pv[0]), vec3(pv[1])}; }

// Earth and sun at a moment, and the frame of the celestial pole and origin then.
struct Ephemeris {
    double earth_pv[2][3];
    double sun_to_earth[3];
    State earth;
    State sun;
    double x, y, s;  // celestial intermediate pole and origin
    TimeScales time;
};

Ephemeris ephemeris(const Utc& moment, double ut1_minus_utc_s) {
    Ephemeris e{};
    e.time = time_scales(moment, ut1_minus_utc_s);
    const auto [tt1, tt2] = e.time.tt;
    double heliocentric[2][3];
    eraEpv00(tt1, tt2, heliocentric, e.earth_pv);
    eraCp(heliocentric[0], e.sun_to_earth);
    e.earth = state(e.earth_pv);
    const State from_sun = state(heliocentric);
    e.sun = {e.earth.position - from_sun.position, e.earth.velocity - from_sun.velocity};
    // The short nutation series IAU 2000B: 1 mas, and a tenth of the cost of the full one.
    double matrix[3][3];
    eraPnm00b(tt1, tt2, matrix);
    eraBpn2xy(matrix, &e.x, &e.y);
    e.s = eraS00(tt1, tt2, e.x, e.y);
    return e;
}

State moon_state(const Ephemeris& e) {
    double pv[2][3];
    eraMoon98(e.time.tt.first, e.time.tt.second, pv);
    return {e.earth.position + vec3(pv[0]), e.earth.velocity + vec3(pv[1])};
}

// The observer: where he is, how he moves, how the Earth has turned. No polar motion: it stays below 0.0002 deg.
eraASTROM observer(const Ephemeris& e, const Place& place) {
    Ephemeris copy = e;  // ERFA takes pointers to what it does not change
    const auto [tt1, tt2] = e.time.tt;
    const double rotation = eraEra00(e.time.ut1.first, e.time.ut1.second);
    eraASTROM astrom{};
    eraApco(tt1, tt2, copy.earth_pv, copy.sun_to_earth, e.x, e.y, e.s, rotation, place.longitude, place.latitude, place.altitude.in(m), 0.0,
            0.0, eraSp00(tt1, tt2), 0.0, 0.0, &astrom);
    return astrom;
}

// Where a body was when the light left it that reaches `eye` now, from `eye`, in au. Two steps settle the moon's and the
// sun's light time to microseconds.
Vec3 seen_from(const Vec3& eye, const State& body) {
    Vec3 ray = body.position - eye;
    for (int i = 0; i < 2; ++i) ray = body.position - body.velocity * (glm::length(ray) * light_days_per_au) - eye;
    return ray;
}

// Right ascension and declination from the celestial intermediate origin, with the observer's aberration.
std::pair<double, double> intermediate_place(const Vec3& ray, eraASTROM& astrom) {
    const Vec3 unit = glm::normalize(ray);
    double natural[3] = {unit.x, unit.y, unit.z};
    double proper[3];
    double rotated[3];
    double ascension = 0.0;
    double declination = 0.0;
    eraAb(natural, astrom.v, astrom.em, astrom.bm1, proper);
    eraRxp(astrom.bpn, proper, rotated);
    eraC2s(rotated, &ascension, &declination);
    return {ascension, declination};
}

HorizontalDirection horizontal(const Vec3& ray, eraASTROM& astrom, const SkyOptions& options) {
    auto [ascension, declination] = intermediate_place(ray, astrom);
    double azimuth = 0.0;
    double zenith = 0.0;
    double ignored[3];
    eraAtioq(ascension, declination, &astrom, &azimuth, &zenith, &ignored[0], &ignored[1], &ignored[2]);
    if (options.refraction) zenith = refracted_zenith(zenith, *options.refraction);
    return {azimuth, zenith};
}

double angular_radius(double radius_m, double distance_au) { return std::asin(radius_m / (distance_au * au_m)); }

Result<Done> in_range(const char* where, double value, double low, double high, const char* unit, const char* remedy) {
    if (value >= low && value <= high) return Done{};
    return Error{where, fmt::format("{:.10g} {} is out of range: it must be {} to {}", value, unit, low, high), remedy};
}

}  // namespace

Result<Place> place_of(Place place) {
    const auto latitude = in_range("latitude", place.latitude / deg, -90.0, 90.0, "deg", "North is positive, south negative.");
    if (!latitude) return latitude.error();
    const auto longitude = in_range("longitude", place.longitude / deg, -180.0, 180.0, "deg", "East is positive, west negative.");
    if (!longitude) return longitude.error();
    const auto altitude = in_range("altitude", place.altitude.in(m), -500.0, 1e6, "m", "It is the height above sea level in metres.");
    if (!altitude) return altitude.error();
    return place;
}

Result<RefractionAir> refraction_air_of(RefractionAir air) {
    const auto pressure = in_range("pressure", air.pressure_hpa, 0.0, 1100.0, "hPa", "It is the pressure at the eye, not at sea level.");
    if (!pressure) return pressure.error();
    const auto temperature = in_range("temperature", air.temperature_c, -100.0, 60.0, "deg C", "It is in degrees Celsius.");
    if (!temperature) return temperature.error();
    return air;
}

Vec3 east_north_up(const HorizontalDirection& d) {
    return {std::sin(d.zenith) * std::sin(d.azimuth), std::sin(d.zenith) * std::cos(d.azimuth), std::cos(d.zenith)};
}

SunPosition sun_position(const Place& place, const Utc& moment, const SkyOptions& options) {
    assert(place_of(place) && (!options.refraction || refraction_air_of(*options.refraction)));
    const Ephemeris e = ephemeris(moment, options.ut1_minus_utc_s);
    eraASTROM astrom = observer(e, place);
    const Vec3 ray = seen_from(vec3(astrom.eb), e.sun);
    const double distance_au = glm::length(ray);
    return {horizontal(ray, astrom, options), distance_au, angular_radius(sun_radius_m, distance_au)};
}

MoonPosition moon_position(const Place& place, const Utc& moment, const SkyOptions& options) {
    assert(place_of(place) && (!options.refraction || refraction_air_of(*options.refraction)));
    const Ephemeris e = ephemeris(moment, options.ut1_minus_utc_s);
    eraASTROM astrom = observer(e, place);
    const Vec3 eye = vec3(astrom.eb);
    const Vec3 ray = seen_from(eye, moon_state(e));
    const Vec3 to_sun = glm::normalize(e.sun.position - (eye + ray));
    const double distance_au = glm::length(ray);
    const Vec3 to_eye = -ray / distance_au;
    const double phase = std::atan2(glm::length(glm::cross(to_sun, to_eye)), glm::dot(to_sun, to_eye));
    return {horizontal(ray, astrom, options), distance_au * au_m * m, angular_radius(moon_radius.value, distance_au), phase,
            0.5 * (1.0 + std::cos(phase))};
}

double refracted_zenith(double zenith, const RefractionAir& air) {
    constexpr double lowest = -1.0;  // degrees; the formula was made for the sky above the horizon
    const double altitude = 90.0 - zenith / deg;
    const double h = std::max(altitude, lowest);
    double arcmin = std::max(1.02 / std::tan((h + 10.3 / (h + 5.11)) * deg), 0.0);  // -0.002 in the zenith as printed
    if (altitude < lowest) arcmin *= std::tan(lowest * deg) / std::tan(altitude * deg);
    arcmin *= air.pressure_hpa / 1010.0 * 283.0 / (273.0 + air.temperature_c);
    return zenith - arcmin / 60.0 * deg;
}

double equation_of_time_s(const Utc& moment, double ut1_minus_utc_s) {
    Ephemeris e = ephemeris(moment, ut1_minus_utc_s);
    eraASTROM astrom{};
    eraApci(e.time.tt.first, e.time.tt.second, e.earth_pv, e.sun_to_earth, e.x, e.y, e.s, &astrom);
    const double ascension = intermediate_place(seen_from(vec3(astrom.eb), e.sun), astrom).first;
    const double hour_angle = eraEra00(e.time.ut1.first, e.time.ut1.second) - ascension;
    const double mean = 2.0 * pi * (std::fmod(e.time.ut1.first - 0.5, 1.0) + e.time.ut1.second);  // since midnight
    return eraAnpm(hour_angle + pi - mean) / (2.0 * pi) * 86400.0;
}

}  // namespace airlight
