// The air of six model atmospheres by altitude: pressure, temperature and gases.
// Table: data/afgl_atmospheres.source.md [Anderson1986]. Uses units; knows nothing of light.
#pragma once

#include <span>
#include <string_view>

#include "atmosphere/density_profile.h"
#include "core/result.h"
#include "units/units.h"

namespace airlight {

struct AirLevel {
    Length altitude;
    double pressure_hpa;
    double temperature_k;
    NumberDensity air, ozone, water_vapour, nitrogen_dioxide;
};

enum class Gas { air, ozone, water_vapour, nitrogen_dioxide };

inline constexpr std::string_view model_atmosphere_names =
    "us_standard tropical midlatitude_summer midlatitude_winter subarctic_summer subarctic_winter";

// The 50 levels, 0 to 120 km; fails if no model has this name, naming those that there are.
Result<std::span<const AirLevel>> model_atmosphere(std::string_view name);

NumberDensity density_of(const AirLevel& level, Gas gas);

// Density of a gas relative to its greatest; `reference` is that greatest density.
struct GasProfile {
    TabulatedProfile profile;
    NumberDensity reference;
};
GasProfile gas_profile(std::span<const AirLevel> levels, Gas gas);

// Mean temperature in K of a gas, weighted by its density, over the whole column: where a cross-section that varies
// with temperature is best taken for the column's absorption.
double effective_temperature_k(std::span<const AirLevel> levels, Gas gas);

}  // namespace airlight
