// What models are judged under: air over a ground, an eye, a sun; and the directions in which they are asked.
// Uses the atmosphere and the sky's views.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "atmosphere/atmosphere.h"
#include "sky/sky.h"

namespace airlight {

// An atmosphere under the name that reports show.
struct Air {
    std::string name;  // "earth-clear", "earth-clear over snow"
    Atmosphere atmosphere;
};

// The atmosphere over a ground: "own" leaves it, "black" reflects nothing, anything else is a ground_material().
Result<Air> air_over(const std::string& name, const Atmosphere& atmosphere, std::string_view ground);

struct Condition {
    Length altitude = 0.0 * m;  // of the eye
    double sun_zenith_deg = 0.0;
};
// "eye 2 km, sun 60°".
std::string condition_text(const Condition& condition);

// A direction in which models are judged.
struct JudgedDirection {
    Direction direction;
    bool above_horizon;  // of the ground sphere, from this eye
};

// Twelve above the horizon, from the zenith to 0.3 deg over it, and four below it (from the air, not from the ground itself);
// from space (an eye above the air) six across the limb, to the top of the air, and six on the disk of the planet.
// Those within 1 deg of the sun are left out: there the sun's disk smears the aerosol's forward peak.
std::vector<JudgedDirection> judged_directions(const Atmosphere& atmosphere, const Condition& condition);

// Zenith angle of the geometric horizon, radians.
double horizon_zenith(Length bottom_radius, Length altitude);

View view_of(const Condition& condition, const Direction& direction);

}  // namespace airlight
