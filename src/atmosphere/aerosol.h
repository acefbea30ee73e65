// Aerosol as a constituent: what it is made of, and how much of it there is.
// Theory: docs/theory.md, section 2. Uses optics (Mie, laws of amount) and the description.
#pragma once

#include <variant>

#include "atmosphere/atmosphere.h"
#include "atmosphere/constituents.h"
#include "optics/aerosol.h"
#include "optics/aerosol_laws.h"

namespace airlight {

// The optics of one unit of an aerosol; `extinction` is relative to that at 550 nm.
struct AerosolMatter {
    SpectrumOf<Number> extinction = SpectrumOf<Number>::constant(1.0);
    SpectrumOf<Number> single_scattering_albedo = SpectrumOf<Number>::constant(1.0);
    PhaseFunction phase = IsotropicPhase{};
    InverseLength typical_extinction_550 = 0.0 * per_m;  // at the ground, where such aerosol is at home; 0 if not known
};

inline constexpr double usual_relative_humidity = 50.0;  // percent; OPAC's numbers of particles are given for it

// OPAC's aerosol at 16 wavelengths from 300 to 1000 nm; relative_humidity in percent, 0 to 99. Fails if it is not.
Result<AerosolMatter> opac_matter(AerosolType type, double relative_humidity);

// Its typical_extinction_550 alone, sixteen times faster.
Result<InverseLength> opac_extinction_550(AerosolType type, double relative_humidity);

// The layer in which OPAC has it.
DensityProfile opac_profile(AerosolType type);

// Extinction that falls with the power `alpha` of wavelength, 300 to 1000 nm. [Angstrom1929]
SpectrumOf<Number> angstrom_extinction(double alpha);

// How much: one of these, or an AngstromLaw, whose own law of wavelength takes the place of the matter's.
struct OpticalDepth550 {
    double value;  // vertical, >= 0
};
struct Visibility {
    Length distance;                   // at the ground, >= 1 mm
    double contrast = range_contrast;  // at which a black object is lost there, 0 < contrast < 1
};
struct Turbidity {
    double value;  // vertical optical depth of air and aerosol over that of air, at 550 nm, >= 1 [Preetham1999]
};
struct GroundExtinction550 {
    InverseLength value;  // where the profile is 1, >= 0
};
struct TypicalAmount {
    double factor;  // times the matter's typical extinction, >= 0
};
using AerosolAmount = std::variant<OpticalDepth550, Visibility, Turbidity, AngstromLaw, GroundExtinction550, TypicalAmount>;

// The aerosol that leaves this amount in an atmosphere of air `molecules` and height `top`.
// Fails if the amount is out of its range, or less than clean air alone gives (a visibility beyond that of air).
Result<Constituent> aerosol_constituent(const AerosolMatter& matter, const DensityProfile& profile, const AerosolAmount& amount,
                                        const MolecularAir& molecules, Length top);

}  // namespace airlight
