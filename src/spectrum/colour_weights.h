// From radiance at a few wavelengths to colour: fixed weights, one triple a wavelength.
// Theory: docs/theory.md, section 6.
// Uses the grid, the sun's spectrum and the standard observer.
#pragma once

#include <span>
#include <vector>

#include "spectrum/cie.h"
#include "spectrum/wavelength_grid.h"

namespace airlight {

// Sunlight that air has scattered is the sun's jagged spectrum times a smooth function of wavelength. The smooth
// factor, radiance over solar irradiance, is interpolated between the grid's wavelengths by a natural cubic spline
// (constant past its ends), multiplied with the full solar spectrum and the colour-matching functions, and summed over
// bands of 5 nm. All of this is linear in the radiance, so it is one weight a wavelength.
// With the standard grid, luminance is within 0.3 % and chromaticity within 0.002 in u'v' of the full sum for skies and
// suns at any air mass (tests/laws/spectrum_colour_test.cpp).
class ColourWeights {
public:
    // `sun` is the spectrum that the radiances were computed with (any multiple of it), above 0 at each wavelength.
    ColourWeights(const WavelengthGrid& grid, const SpectrumOf<SpectralIrradiance>& sun);

    // Colour of `spectrum`, one value a wavelength: of radiances in W m-2 sr-1 nm-1, y is in cd m-2;
    // of irradiances in W m-2 nm-1, in lux.
    Xyz to_xyz(std::span<const double> spectrum) const;
    Xyz to_xyz(std::span<const float> spectrum) const;

    // The weights themselves, one triple a wavelength, for shaders and tables.
    std::span<const Xyz> weights() const { return weights_; }

private:
    std::vector<Xyz> weights_;
};

}  // namespace airlight
