// Spectra of daylight from their chromaticity: what models of the sky that know colour, but no wavelength, are made spectral with.
// Theory: docs/theory.md, section 6; table: data/daylight.source.md [CIE2018].
#pragma once

#include <span>
#include <vector>

#include "spectrum/cie.h"

namespace airlight {

// Radiance at fixed wavelengths, 300 to 830 nm, for any chromaticity and luminance.
class Daylight {
public:
    explicit Daylight(std::span<const Wavelength> wavelengths);

    // Radiance of luminance `y` (cd m-2), in W m-2 sr-1 nm-1, written to `radiance` [N]; 0 where the spectrum of a chromaticity
    // that no daylight has would be negative.
    void radiance(Chromaticity colour, double y, std::span<double> radiance) const;
    void radiance(Chromaticity colour, double y, std::span<float> radiance) const;

private:
    // Amounts of the mean and of the two characteristic spectra, for luminance 1.
    struct Amounts {
        double mean, first, second;
    };
    Amounts amounts(Chromaticity colour) const;

    struct Sample {
        double mean, first, second;
    };
    std::vector<Sample> samples_;  // at each wavelength
    Sample luminance_;             // of each of the three, in cd m-2 per W m-2 sr-1 nm-1
};

}  // namespace airlight
