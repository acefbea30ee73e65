#include "optics/rayleigh.h"

#include <cassert>
#include <cmath>

namespace airlight {

namespace {

// The square of the wavenumber in um-2.
double wavenumber2(Wavelength wavelength) {
    const double per_um = 1000.0 / wavelength.in(nm);
    return per_um * per_um;
}

// Acceleration of gravity in m s-2 at the mean altitude, by mass, of the air above the ground. [List1968; Bodhaine1999, eq. 26]
double gravity_of_column(const AirColumn& column) {
    const double z = 0.73737 * column.altitude.in(m) + 5517.56;
    const double c = std::cos(2.0 * column.latitude);
    const double at_sea = 980.6160 * (1.0 - 0.0026373 * c + 0.0000059 * c * c);
    return 0.01 * (at_sea - (3.085462e-4 + 2.27e-7 * c) * z + (7.254e-11 + 1.0e-13 * c) * z * z - (1.517e-17 + 6.0e-20 * c) * z * z * z);
}

}  // namespace

double refractive_index_of_air(Wavelength wavelength, double co2_ppm) {
    assert(230.0 * nm <= wavelength && wavelength <= 1690.0 * nm);
    const double s = wavenumber2(wavelength);
    const double with_300_ppm = 1e-8 * (8060.51 + 2480990.0 / (132.274 - s) + 17455.7 / (39.32957 - s));
    return 1.0 + with_300_ppm * (1.0 + 0.54 * 1e-6 * (co2_ppm - 300.0));
}

double king_factor_of_air(Wavelength wavelength, double co2_ppm) {
    const double s = wavenumber2(wavelength);
    const double nitrogen = 1.034 + 3.17e-4 * s;
    const double oxygen = 1.096 + 1.385e-3 * s + 1.448e-4 * s * s;
    const double argon = 1.0;
    const double carbon_dioxide = 1.15;
    const double co2_percent = 1e-4 * co2_ppm;
    return (78.084 * nitrogen + 20.946 * oxygen + 0.934 * argon + co2_percent * carbon_dioxide) / (78.084 + 20.946 + 0.934 + co2_percent);
}

Area rayleigh_cross_section_of_air(Wavelength wavelength, double co2_ppm) {
    return rayleigh_cross_section(refractive_index_of_air(wavelength, co2_ppm), standard_number_density,
                                  king_factor_of_air(wavelength, co2_ppm), wavelength);
}

double refractive_index_of_carbon_dioxide(Wavelength wavelength) {
    assert(180.0 * nm <= wavelength && wavelength <= 1700.0 * nm);
    // In print the factor is 1.1427e6; 1e3 gives the refractivity of 4.5e-4 at 0 C that all measurements give.
    const double s = 1e8 * wavenumber2(wavelength);  // cm-2
    const auto term = [s](double strength, double resonance) { return strength / (resonance * resonance - s); };
    return 1.0 + 1.1427e3 * (term(5799.25, 128908.9) + term(120.05, 89223.8) + term(5.3334, 75037.5) + term(4.3244, 67837.7) +
                             term(0.1218145e-4, 2418.136));
}

double king_factor_of_carbon_dioxide(Wavelength wavelength) { return 1.1364 + 25.3e-4 * wavenumber2(wavelength); }

Area rayleigh_cross_section_of_carbon_dioxide(Wavelength wavelength) {
    return rayleigh_cross_section(refractive_index_of_carbon_dioxide(wavelength), standard_number_density,
                                  king_factor_of_carbon_dioxide(wavelength), wavelength);
}

Area rayleigh_cross_section(double n, NumberDensity density, double king_factor, Wavelength wavelength) {
    const auto area = as_length(wavelength) * as_length(wavelength);
    const double polarisability = (n - 1.0) * (n + 1.0) / (n * n + 2.0);
    return 24.0 * pi * pi * pi * polarisability * polarisability * king_factor / (area * area * density * density);
}

InverseLength simple_rayleigh_scattering(double n, NumberDensity density, Wavelength wavelength) {
    const auto area = as_length(wavelength) * as_length(wavelength);
    const double contrast = (n - 1.0) * (n + 1.0);
    return 8.0 * pi * pi * pi * contrast * contrast / (3.0 * area * area * density);
}

double depolarisation(double king_factor) { return 6.0 * (king_factor - 1.0) / (3.0 + 7.0 * king_factor); }

double molecules_per_m2(const AirColumn& column) {
    constexpr double avogadro = 6.0221367e23;  // per mol, as in the source; today's value moves nothing printed
    const double kg_per_mol = 1e-3 * (28.9595 + 15.0556 * 1e-6 * column.co2_ppm);
    return column.pressure_pa * avogadro / (kg_per_mol * gravity_of_column(column));
}

double rayleigh_optical_depth(Wavelength wavelength, const AirColumn& column) {
    return rayleigh_cross_section_of_air(wavelength, column.co2_ppm).in(m2)*molecules_per_m2(column);
}

}  // namespace airlight
