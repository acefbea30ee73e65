// What the eye makes of a spectrum: the CIE 1931 standard observer, and colour as it sees it.
// Theory: docs/theory.md, section 6; table: data/cie1931_2deg.source.md [CIE2018].
// Uses units; knows nothing of displays.
#pragma once

#include <span>

#include "units/curve.h"

namespace airlight {

// Colour in absolute terms: of a radiance, y is the luminance in cd m-2; of an irradiance, the illuminance in lux.
struct Xyz {
    double x, y, z;

    friend Xyz operator+(Xyz a, Xyz b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Xyz operator*(double a, Xyz b) { return {a * b.x, a * b.y, a * b.z}; }
};

// The direction of a colour, without its brightness: x = X / (X + Y + Z), y = Y / (X + Y + Z).
struct Chromaticity {
    double x, y;
};

// The same in the CIE 1976 diagram, where equal distances look about equally different (0.002 is hard to see).
struct UniformChromaticity {
    double u, v;
};

// Luminous efficacy of 555 nm (540 THz), exact by the definition of the candela, in lm/W.
inline constexpr double lumen_per_watt = 683.0;

// One step of the colour-matching functions.
struct ColourMatch {
    double wavelength_nm, x, y, z;
};
inline constexpr double cie_step_nm = 5.0;
std::span<const ColourMatch> cie1931();  // 360 to 830 nm, 95 rows

// Colour of a spectrum known between 360 and 830 nm: the sum over bands of 5 nm. Past its samples a curve is constant.
Xyz to_xyz(const SpectrumOf<SpectralRadiance>& radiance);
Xyz to_xyz(const SpectrumOf<SpectralIrradiance>& irradiance);

double luminance(const SpectrumOf<SpectralRadiance>& radiance);        // cd m-2
double illuminance(const SpectrumOf<SpectralIrradiance>& irradiance);  // lux

// Black has no chromaticity: x + y + z must be above 0.
Chromaticity chromaticity(Xyz colour);
UniformChromaticity uniform_chromaticity(Xyz colour);
double distance(UniformChromaticity a, UniformChromaticity b);

// The colour of a chromaticity (y > 0) at a luminance.
Xyz with_luminance(Chromaticity chromaticity, double y);

}  // namespace airlight
