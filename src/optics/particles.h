// What the aerosol of the air is made of: OPAC's components, and how they grow in moist air.
// Theory: docs/theory.md, section 3.4. Uses size distributions; knows nothing of how many particles there are.
#pragma once

#include <string_view>

#include "optics/size_distribution.h"
#include "units/units.h"

namespace airlight {

// Source of all figures: data/aerosol_components.source.md; [HessKoepkeSchult1998, table 1].
enum class AerosolComponent {
    insoluble,              // soil dust with organic matter
    water_soluble,          // sulfates, nitrates, organic matter; grows with humidity
    soot,                   // black carbon
    sea_salt_accumulation,  // grows with humidity, as the coarse mode does
    sea_salt_coarse,
    mineral_nucleation,  // desert dust, in three modes
    mineral_accumulation,
    mineral_coarse,
    mineral_transported,  // desert dust carried far
    sulfate,              // droplets of sulfuric acid; grows with humidity
};

inline constexpr int aerosol_component_count = 10;

// "water_soluble"
std::string_view name(AerosolComponent component);

inline constexpr double greatest_relative_humidity = 99.0;  // percent; beyond it droplets of fog form

// The wavelengths for which every component has a refractive index.
inline constexpr Wavelength first_aerosol_wavelength = 250.0 * nm;
inline constexpr Wavelength last_aerosol_wavelength = 1000.0 * nm;

// Linear between the tabulated humidities 0, 50, 70, 80, 90, 95, 98, 99 %; components that do not grow have one entry.
//   relative_humidity  percent, 0 to greatest_relative_humidity
LognormalSizes sizes_of(AerosolComponent component, double relative_humidity);

// Linear in humidity and in wavelength; first_aerosol_wavelength <= wavelength <= last_aerosol_wavelength.
RefractiveIndex refractive_index_of(AerosolComponent component, double relative_humidity, Wavelength wavelength);

}  // namespace airlight
