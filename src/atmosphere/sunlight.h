// The real sun as a description holds it: its spectrum, its size and its limb.
// Uses the solar spectrum; knows nothing of where the sun stands.
#pragma once

#include "atmosphere/atmosphere.h"

namespace airlight {

inline constexpr double solar_angular_radius_1au = 0.266564 * deg;  // 959.63 arcseconds [Cox2000, sec. 14.1]

// The sun at `distance_au` astronomical units, > 0: ASTM G173's spectrum, thinned with the square of the distance, and a
// darkened disk.
Sun sun_at(double distance_au);

// Limb darkening from 300 to 1000 nm. [Cox2000, sec. 14.7], whose law 1 - u - v + u mu + v mu^2 is this project's with
// u_1 = u + 2 v and u_2 = -v.
struct LimbDarkening {
    SpectrumOf<Number> first, second;
};
LimbDarkening solar_limb_darkening();

}  // namespace airlight
