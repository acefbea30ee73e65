// Preetham's form for one quantity, fitted to the skies of all turbidities and suns at once. [Preetham1999]
// Uses least squares and the form of the file; knows nothing of how skies are computed.
#pragma once

#include <span>
#include <vector>

#include "fit/perez_form.h"
#include "models/preetham1999_data.h"

namespace airlight {

// The sky of one turbidity and sun.
struct PreethamSky {
    double turbidity;
    double sun_zenith;
    std::vector<PerezSample> samples;
};

// The coefficients of a quantity, luminance (cd m-2) or else chromaticity, in the order of the file: those of the least mean square of
// relative differences.
//   turbidities  those of the skies, increasing. Coefficients are linear in turbidity; those of the zenith's chromaticity have a
//                square if there are three turbidities
std::vector<TurbidityPolynomial> fitted_preetham(std::span<const PreethamSky> skies, std::span<const double> turbidities, bool luminance);

}  // namespace airlight
