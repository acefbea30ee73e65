// Sun and moon as a frame is told of them, and their light in red, green and blue.
// Uses celestial and colours; knows no GPU.
#pragma once

#include <array>
#include <optional>

#include "atmosphere/atmosphere.h"
#include "camera/camera.h"

namespace airlight::render {

struct Heavens {
    Vec3 towards_sun;  // of length one, from any place of the planet but for eclipses
    double sun_distance_au = 1.0;
    std::optional<Vec3> moon_m = {};  // its centre, from the planet's; the planet then is where the Earth is
    bool night_sky = false;           // whether there is light between the stars
};

// Angular, radians.
double sun_radius(const Heavens& heavens);

// Linear amounts of the primaries of sRGB, some of them below 0 where a colour lies beyond these.
using RgbLight = Vec3;

// Lux of sunlight above the air on a surface that faces the sun, of which a share is taken at each wavelength.
RgbLight sunlight(const Heavens& heavens, const SpectrumOf<Number>& share);

// Radiance of the sun's disk above the air where 1 - mu is 0, and what its first and second powers take from it: cd m-2.
std::array<RgbLight, 3> sun_radiance(const Heavens& heavens);

// The moon as an eye sees it.
struct MoonSeen {
    Vec3 towards;           // of length one
    double angular_radius;  // radians
    Vec3 to_sun;            // from the moon, of length one
    double phase_angle;     // sun - moon - eye, radians
    RgbLight lit;           // cd m-2 where the sun stands as high over the moon's ground as the eye does
    RgbLight dark;          // cd m-2 by the Earth's light
    RgbLight illuminance;   // lux above the air on a surface that faces it
};
std::optional<MoonSeen> moon_seen(const Heavens& heavens, Vec3 eye_m);

// The light between the stars (celestial/night_sky.h).
struct NightLight {
    RgbLight beyond;       // cd m-2 from outside of the air
    RgbLight airglow;      // cd m-2 of the glowing layer, crossed upright
    RgbLight scattered;    // cd m-2 of air that light goes through no more: of a half of all directions such a sky sends light into it
    RgbLight illuminance;  // lux on level ground
};
NightLight night_light();

// What takes sunlight from a planet.
struct Eclipse {
    Vec3 moon_m;  // from the eye
    double moon_radius_m;
    double sun_radius;  // angular, radians
    double sun_distance_m;
};
// None if no point within `reach_m` of the planet's centre sees the moon before the sun.
std::optional<Eclipse> eclipse_of(const Heavens& heavens, Vec3 eye_m, double reach_m);

}  // namespace airlight::render
