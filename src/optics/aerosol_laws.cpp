#include "optics/aerosol_laws.h"

#include <fmt/format.h>

#include <cassert>
#include <cmath>

#include "units/text.h"

namespace airlight {

double optical_depth(const AngstromLaw& law, Wavelength wavelength) { return law.beta * std::pow(wavelength.in(nm) / 1000.0, -law.alpha); }

AngstromLaw angstrom_law(Wavelength first, double first_depth, Wavelength second, double second_depth) {
    assert(first_depth > 0.0 && second_depth > 0.0 && first != second);
    const double alpha = -std::log(first_depth / second_depth) / std::log((first / second).value);
    return {first_depth * std::pow(first.in(nm) / 1000.0, alpha), alpha};
}

double angstrom_factor(double alpha, Wavelength from, Wavelength to) { return std::pow((to / from).value, -alpha); }

InverseLength extinction_of_visibility(Length visibility, double contrast) {
    assert(visibility > 0.0 * m && contrast > 0.0 && contrast < 1.0);
    return -std::log(contrast) / visibility;
}

Length visibility_of_extinction(InverseLength extinction, double contrast) {
    assert(extinction > 0.0 * per_m && contrast > 0.0 && contrast < 1.0);
    return -std::log(contrast) / extinction;
}

Result<InverseLength> aerosol_extinction_of_visibility(Length visibility, InverseLength molecular, double contrast) {
    if (!(visibility > 0.0 * m))
        return Error{"", fmt::format("a visibility of {} is out of range: it must be above 0 m", length_text(visibility)), ""};
    const InverseLength aerosol = extinction_of_visibility(visibility, contrast) - molecular;
    if (aerosol < 0.0 * per_m)
        return Error{"",
                     fmt::format("a visibility of {} is out of range: in air without any aerosol one sees {:.0f} km",
                                 length_text(visibility), visibility_of_extinction(molecular, contrast).in(km)),
                     "Give less, or leave the aerosol out."};
    return aerosol;
}

double aerosol_depth_of_turbidity(double turbidity, double molecular_depth) { return (turbidity - 1.0) * molecular_depth; }

double turbidity_of_aerosol_depth(double aerosol_depth, double molecular_depth) { return 1.0 + aerosol_depth / molecular_depth; }

AngstromLaw preetham_angstrom_law(double turbidity) { return {0.04608 * turbidity - 0.04586, 1.3}; }

InverseLength preetham_haze_scattering(double turbidity, Wavelength wavelength) {
    constexpr double K = 0.67;
    const double concentration = (0.6544 * turbidity - 0.6510) * 1e-16;
    const double wavenumber_per_cm = 2.0 * pi / (100.0 * as_length(wavelength).in(m));
    return 100.0 * 0.434 * concentration * pi * wavenumber_per_cm * wavenumber_per_cm * K * per_m;
}

}  // namespace airlight
