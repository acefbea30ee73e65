// Coefficients and vertical optical depths of an atmosphere and of its constituents.
// Theory: docs/theory.md, section 2, eq. 8. Uses the description only.
#pragma once

#include "atmosphere/atmosphere.h"

namespace airlight {

// Of one constituent at relative density one.
InverseLength extinction(const Constituent& constituent, Wavelength wavelength);

// Of all the air at altitude h >= 0; 0 above the top.
InverseLength scattering(const Atmosphere& atmosphere, Length h, Wavelength wavelength);
InverseLength extinction(const Atmosphere& atmosphere, Length h, Wavelength wavelength);

// Vertical optical depth (extinction) from the ground to `top`, of one constituent, and of all to the atmosphere's top.
Number optical_depth(const Constituent& constituent, Length top, Wavelength wavelength);
Number optical_depth(const Atmosphere& atmosphere, Wavelength wavelength);

// Scattering over extinction, 0 to 1; 1 where the constituent does neither.
double single_scattering_albedo(const Constituent& constituent, Wavelength wavelength);

// The same constituent with all its coefficients multiplied by factor >= 0.
Constituent scaled(Constituent constituent, double factor);

}  // namespace airlight
