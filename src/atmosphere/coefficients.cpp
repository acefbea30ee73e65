#include "atmosphere/coefficients.h"

namespace airlight {

namespace {

template <class Coefficient>
InverseLength sum_at(const Atmosphere& atmosphere, Length h, Coefficient coefficient) {
    InverseLength sum = 0.0 * per_m;
    if (h > atmosphere.top_altitude) return sum;
    for (const Constituent& c : atmosphere.constituents) sum += relative_density(c.profile, h) * coefficient(c);
    return sum;
}

}  // namespace

InverseLength extinction(const Constituent& constituent, Wavelength wavelength) {
    return constituent.scattering.at(wavelength) + constituent.absorption.at(wavelength);
}

InverseLength scattering(const Atmosphere& atmosphere, Length h, Wavelength wavelength) {
    return sum_at(atmosphere, h, [&](const Constituent& c) { return c.scattering.at(wavelength); });
}

InverseLength extinction(const Atmosphere& atmosphere, Length h, Wavelength wavelength) {
    return sum_at(atmosphere, h, [&](const Constituent& c) { return extinction(c, wavelength); });
}

Number optical_depth(const Constituent& constituent, Length top, Wavelength wavelength) {
    return extinction(constituent, wavelength) * column_depth(constituent.profile, top);
}

Number optical_depth(const Atmosphere& atmosphere, Wavelength wavelength) {
    Number sum = 0.0;
    for (const Constituent& c : atmosphere.constituents) sum += optical_depth(c, atmosphere.top_altitude, wavelength);
    return sum;
}

double single_scattering_albedo(const Constituent& constituent, Wavelength wavelength) {
    const InverseLength all = extinction(constituent, wavelength);
    return all.value > 0.0 ? (constituent.scattering.at(wavelength) / all).value : 1.0;
}

Constituent scaled(Constituent constituent, double factor) {
    constituent.scattering = constituent.scattering.scaled(factor);
    constituent.absorption = constituent.absorption.scaled(factor);
    return constituent;
}

}  // namespace airlight
