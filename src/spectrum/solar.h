// The sun's light above the atmosphere.
// Table: data/solar_irradiance.source.md [ASTM2012].
// Uses units; knows nothing of the sun's place in the sky.
#pragma once

#include "units/curve.h"

namespace airlight {

// Spectral irradiance on a plane facing the sun, above the atmosphere, 300 to 1000 nm in steps of 5 nm, each the mean of
// its band. `distance_au` is the distance to the sun in astronomical units, > 0: the light thins with its square.
SpectrumOf<SpectralIrradiance> solar_irradiance(double distance_au = 1.0);

}  // namespace airlight
