// Scattering by molecules: refractive index, King factor, cross-section and optical depth of air, and of carbon dioxide.
// Theory: docs/theory.md, section 3.2. Uses quantities; knows nothing of altitudes.
#pragma once

#include "units/units.h"

namespace airlight {

// Molecules in a volume of any gas at 288.15 K and 1013.25 hPa, the state at which refractive indices are given. [Bodhaine1999, sec. 3]
inline constexpr NumberDensity standard_number_density = 2.546899e19 * per_cm3;

// Share of carbon dioxide for which Bodhaine's reference values are given, parts per million by volume.
inline constexpr double standard_co2_ppm = 360.0;

// Of dry air at 288.15 K and 1013.25 hPa; 230 nm <= wavelength <= 1690 nm. [PeckReeder1972, eq. 2; Bodhaine1999, eq. 18 and 19]
double refractive_index_of_air(Wavelength wavelength, double co2_ppm = standard_co2_ppm);

// How much the anisotropy of air's molecules adds to their scattering, > 1. [Bates1984; Bodhaine1999, eq. 23]
double king_factor_of_air(Wavelength wavelength, double co2_ppm = standard_co2_ppm);

// Scattering cross-section of a mean molecule of dry air. [Bodhaine1999, eq. 2]
Area rayleigh_cross_section_of_air(Wavelength wavelength, double co2_ppm = standard_co2_ppm);

// The same three for pure carbon dioxide, nearly the air of Mars and Venus; 180 nm <= wavelength <= 1700 nm. [SneepUbachs2005, eq. 4 and table 2]
double refractive_index_of_carbon_dioxide(Wavelength wavelength);
double king_factor_of_carbon_dioxide(Wavelength wavelength);
Area rayleigh_cross_section_of_carbon_dioxide(Wavelength wavelength);

// Of one molecule of a gas whose refractive index is `n` at `density`. [Bodhaine1999, eq. 2]
//   king_factor  1 for isotropic molecules
Area rayleigh_cross_section(double n, NumberDensity density, double king_factor, Wavelength wavelength);

// The scattering coefficient of a gas in the short form of computer graphics, 8 pi^3 (n^2 - 1)^2 / (3 N lambda^4):
// without King's factor, and with n^2 + 2 taken as 3. [Nielsen2003, eq. 2.2; NishitaEtAl1993, eq. 3]
InverseLength simple_rayleigh_scattering(double n, NumberDensity density, Wavelength wavelength);

// The depolarisation ratio for natural light that a King factor (6 + 3 rho) / (6 - 7 rho) stands for; RayleighPhase takes it.
double depolarisation(double king_factor);

// Where a column of air stands on the ground.
struct AirColumn {
    double pressure_pa = 101325.0;  // at the ground
    double latitude = 45.0 * deg;   // radians
    Length altitude = 0.0 * m;      // of the ground above the sea
    double co2_ppm = standard_co2_ppm;
};

// Molecules above a square metre. [Bodhaine1999, eq. 17, 26 and 27]
double molecules_per_m2(const AirColumn& column);

// Vertical optical depth of the whole column for Rayleigh scattering. [Bodhaine1999, eq. 27]
double rayleigh_optical_depth(Wavelength wavelength, const AirColumn& column = {});

}  // namespace airlight
