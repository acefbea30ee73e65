// Pure sea water: how much it absorbs and scatters.
#pragma once

#include <array>

#include "physics/models/f64.h"
#include "transport/air_optics.h"

namespace airlight {

struct SeaWater {
    f64::ScatteringSpectrum absorption;
    f64::ScatteringSpectrum scattering;
};

// At the wavelengths of a pack; beyond 380 to 700 nm the values at the ends.
SeaWater sea_water(const std::array<Wavelength, pack_size>& wavelengths);

}  // namespace airlight
