// Air that is baked quickly for tests of whole frames, at four wavelengths.
#pragma once

#include <vector>

#include "transport/bake_settings.h"
#include "units/units.h"
#include "units/vector.h"

namespace airlight::test {

// Three of them are the three channels.
inline const std::vector<Wavelength> wavelengths = {450.0 * nm, 500.0 * nm, 550.0 * nm, 650.0 * nm};
inline const std::vector<Vec3> colours = {{0, 0, 1}, {0, 0, 0}, {0, 1, 0}, {1, 0, 0}};
inline const BakeSettings bake = {
    .sizes = {.transmittance_mu = 64, .transmittance_altitude = 32, .sun = 24, .azimuth = 4, .view = 8, .altitude = 12}, .orders = 2};

}  // namespace airlight::test
