// The temperature of the glowing body whose colour is nearest to a light's.
// Theory: docs/theory.md, section 6.
// Uses the standard observer.
#pragma once

#include <optional>

#include "spectrum/cie.h"

namespace airlight {

struct ColourTemperature {
    double kelvin;    // of the nearest colour on the locus of black bodies
    double distance;  // from it in the CIE 1960 diagram; above 0: greener, below 0: more purple
};

// Colour of a black body, luminance 1; kelvin from 500 to 1e9 (Planck's law, second radiation constant 1.4388e-2 m K).
Xyz black_body_colour(double kelvin);

// Correlated colour temperature, by search along the locus in the CIE 1960 diagram, where it is defined (CIE 015:2018).
// None where the notion has no meaning: black, further from the locus than 0.05, or bluer than any black body (many a
// deep blue sky is).
std::optional<ColourTemperature> correlated_colour_temperature(Xyz colour);

}  // namespace airlight
