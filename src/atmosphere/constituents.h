// Constituents by their physical causes: so much air, ozone, nitrogen dioxide or carbon dioxide, spread in such a way.
// Theory: docs/theory.md, section 2. Uses optics (cross-sections) and the model atmospheres.
#pragma once

#include <string_view>

#include "atmosphere/atmosphere.h"
#include "atmosphere/model_atmosphere.h"

namespace airlight {

inline constexpr double standard_pressure_hpa = 1013.25;
inline constexpr double dobson_unit_per_m2 = 2.6867e20;  // molecules in 1e-5 m of gas at 0 deg C and 1013.25 hPa

// Whether a column depth is one by which an amount can be divided: a profile must hold something, but not without end.
constexpr bool is_column_depth(Length depth) { return depth >= 0.001 * m && depth <= 1e12 * m; }
inline constexpr std::string_view column_depth_rule =
    "below the top it must hold as much as a layer from 1 mm to 1e9 km deep at density one";

// Dry air over the whole spectrum of its formulas that this project uses: 300 to 1000 nm, every 2 nm.
//   profile       whose column_depth() up to 1000 km passes is_column_depth(), here and below
//   pressure_hpa  at the ground, > 0: the column holds the molecules that it stands for [Bodhaine1999, eq. 24 to 28]
Constituent air_constituent(const DensityProfile& profile, double pressure_hpa = standard_pressure_hpa);

inline constexpr Length above_all_air = 1000.0 * km;

// Carbon dioxide whose number density is `reference` where the profile is 1.
Constituent carbon_dioxide_constituent(const DensityProfile& profile, NumberDensity reference);

// A gas that absorbs: ozone, or nitrogen dioxide.
//   column_per_m2  molecules above a square metre, >= 0
//   temperature_k  of the cross-section
Constituent absorber_constituent(Gas gas, const DensityProfile& profile, double column_per_m2, double temperature_k);

// Molecules above a square metre in a model atmosphere.
double column_per_m2(std::span<const AirLevel> levels, Gas gas);

// Air's molecules alone: the scattering coefficient at the ground and the vertical optical depth of those constituents
// that scatter by Rayleigh's law; of standard air if there are none.
struct MolecularAir {
    InverseLength scattering_at_ground;
    double optical_depth;
};
MolecularAir molecular_air(const Atmosphere& atmosphere, Wavelength wavelength);

}  // namespace airlight
