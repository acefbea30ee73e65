// The stars that an eye sees: where they stand at a moment, their light and colour.
// Table: data/stars.source.md [AndersonFrancis2012]. docs/theory.md, section 7.3. Uses ERFA and colours.
#pragma once

#include <vector>

#include "spectrum/cie.h"
#include "sun/time.h"
#include "units/vector.h"

namespace airlight {

struct Star {
    Vec3 direction;   // of length one, along Earth-fixed axes
    Xyz illuminance;  // lux, on a plane that faces it, above the air
};

// Lux of a star of visual magnitude 0 above the air [Cox2000].
inline constexpr double lux_of_magnitude_0 = 2.54e-6;

// Kelvin of the black body of a colour index, -0.4 to 4 [Ballesteros2012, eq. 14].
double temperature_of_colour_index(double b_minus_v);

// The stars of magnitude `faintest` or brighter, at most 6.0, the brightest first. Precession, nutation and the Earth's rotation turn
// them; without proper motion and aberration they stand within 0.03 degrees of where they are seen in this century.
std::vector<Star> stars_at(const Utc& moment, double faintest);

}  // namespace airlight
