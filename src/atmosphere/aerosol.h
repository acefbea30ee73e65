// Aerosol as a constituent: what it is made of, and how much of it there is.
// Theory: docs/theory.md, section 2. Uses optics (Mie, laws of amount) and the description.
#pragma once

#include <variant>

#include "atmosphere/atmosphere.h"
#include "atmosphere/constituents.h"

namespace airlight {

// The optics of one unit of an aerosol; `extinction` is relative to that at 550 nm.
struct AerosolMatter {
    SpectrumOf<Number> extinction = SpectrumOf<Number>::constant(1.0);
    SpectrumOf<Number> single_scattering_albedo = SpectrumOf<Number>::constant(1.0);
    PhaseFunction phase = IsotropicPhase{};
};

// Extinction that falls with the power `alpha` of wavelength, 300 to 1000 nm. [Angstrom1929]
SpectrumOf<Number> angstrom_extinction(double alpha);

// How much: one of these.
struct OpticalDepth550 {
    double value;  // vertical, >= 0
};
struct Visibility {
    Length distance;  // meteorological optical range at the ground, > 0 [Koschmieder1924]
};
struct Turbidity {
    double value;  // vertical optical depth of air and aerosol over that of air, at 550 nm, >= 1 [Preetham1999]
};
struct AngstromAmount {
    double alpha;  // its own law of wavelength takes the place of the matter's
    double beta;   // vertical optical depth at 1000 nm, >= 0
};
struct GroundExtinction550 {
    InverseLength value;  // where the profile is 1, >= 0
};
using AerosolAmount = std::variant<OpticalDepth550, Visibility, Turbidity, AngstromAmount, GroundExtinction550>;

// The aerosol that leaves this amount in an atmosphere of air `molecules` and height `top`.
// Fails if the amount is out of its range, or less than clean air alone gives (a visibility beyond that of air).
Result<Constituent> aerosol_constituent(const AerosolMatter& matter, const DensityProfile& profile, const AerosolAmount& amount,
                                        const MolecularAir& molecules, Length top);

}  // namespace airlight
