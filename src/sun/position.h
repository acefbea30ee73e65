// Where the sun and the moon stand in the sky of a place at a moment, how far and how large they are.
// docs/theory.md, section 7. Uses ERFA; knows nothing of the atmosphere but its refraction.
#pragma once

#include <optional>

#include "core/result.h"
#include "sun/time.h"
#include "units/units.h"
#include "units/vector.h"

namespace airlight {

inline constexpr Length astronomical_unit = 149597870700.0 * m;  // IAU 2012 resolution B2
inline constexpr Length moon_radius = 1737.4 * km;               // IAU 2015 working group on cartographic coordinates

// A point on or above the WGS 84 ellipsoid.
struct Place {
    double latitude = 0.0;      // radians, north positive, [-pi/2, pi/2]; geodetic
    double longitude = 0.0;     // radians, east positive, [-pi, pi]
    Length altitude = 0.0 * m;  // above the ellipsoid, -500 m to 1000 km
};

// `place` if it exists. Fails, in degrees and metres, for a coordinate out of range: "latitude", "longitude", "altitude"
// is then where the error says.
Result<Place> place_of(Place place);

// The air at the eye, for refraction.
struct RefractionAir {
    double pressure_hpa = 1013.25;  // 0 to 1100
    double temperature_c = 15.0;    // -100 to 60
};

// `air` if it can be. Fails for a value out of range; "pressure" or "temperature" is then where the error says.
Result<RefractionAir> refraction_air_of(RefractionAir air);

// How a position is computed.
struct SkyOptions {
    std::optional<RefractionAir> refraction = {};  // none: the direction of the straight line, as a renderer wants it
    double ut1_minus_utc_s = 0.0;                  // published by the IERS; |.| < 0.9 s
};

// A direction seen from a place.
struct HorizontalDirection {
    double azimuth;  // radians from north, clockwise (east is pi/2), [0, 2 pi)
    double zenith;   // radians from straight up, [0, pi]
};

// The unit vector of a direction: x east, y north, z up.
Vec3 east_north_up(const HorizontalDirection& direction);

struct SunPosition {
    HorizontalDirection direction;  // of the centre of the disk, topocentric and apparent
    double distance_au;             // from the eye, 0.983 to 1.017
    double angular_radius;          // radians
};

struct MoonPosition {
    HorizontalDirection direction;  // of the centre of the disk, topocentric and apparent
    Length distance;                // from the eye
    double angular_radius;          // radians
    double phase_angle;             // sun - moon - eye, radians: 0 full, pi new
    double illuminated_fraction;    // of the disk, [0, 1]
};

// Geometry good to 0.0005 deg for the sun and 0.004 deg for the moon (ERFA's series after [Meeus1998]) in 1972-2035, if UT1 -
// UTC is given; without it (0) and outside these years the Earth's rotation is uncertain by up to 0.004 deg for each second of
// UT1.
SunPosition sun_position(const Place& place, const Utc& moment, const SkyOptions& options = {});
MoonPosition moon_position(const Place& place, const Utc& moment, const SkyOptions& options = {});

// The apparent zenith angle of what stands at `zenith` without air, by Saemundsson's formula [Saemundsson1986]: within
// 0.17 arcmin of standard refraction from the zenith to the horizon; from 1 deg below it on it fades out.
double refracted_zenith(double zenith, const RefractionAir& air);

// Apparent minus mean solar time, in seconds, -860 to 990 in this age.
double equation_of_time_s(const Utc& moment, double ut1_minus_utc_s = 0.0);

}  // namespace airlight
