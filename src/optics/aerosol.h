// The aerosol of a kind of place at a humidity: how strongly it scatters and absorbs near the ground, and whereto.
// Theory: docs/theory.md, section 3.4. Uses particles and phase functions; knows nothing of altitudes but the layer's own.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "optics/particles.h"
#include "optics/phase_function.h"
#include "units/curve.h"
#include "units/units.h"

namespace airlight {

// OPAC's types. Source: data/aerosol_types.source.md; [HessKoepkeSchult1998, tables 4 and 5].
enum class AerosolType { continental_clean, continental_average, continental_polluted, urban, desert, maritime_clean, maritime_polluted };

inline constexpr AerosolType aerosol_types[] = {AerosolType::continental_clean,
                                                AerosolType::continental_average,
                                                AerosolType::continental_polluted,
                                                AerosolType::urban,
                                                AerosolType::desert,
                                                AerosolType::maritime_clean,
                                                AerosolType::maritime_polluted};

// "continental_average"; and back, failing with the nearest name.
std::string_view name(AerosolType type);
Result<AerosolType> parse_aerosol_type(std::string_view text);

// Density exp(-h / scale_height) below the top, none above.
struct AerosolLayer {
    Length scale_height;
    Length top;
};
AerosolLayer layer_of(AerosolType type);

// So many particles of one component.
struct AerosolShare {
    AerosolComponent component;
    NumberDensity number;
};
std::vector<AerosolShare> mixture_of(AerosolType type);

// Coefficients near the ground, and the phase function of the mixture, at the wavelengths asked for and linear between them.
struct AerosolOptics {
    SpectrumOf<InverseLength> scattering = SpectrumOf<InverseLength>::constant(0.0 * per_m);
    SpectrumOf<InverseLength> absorption = SpectrumOf<InverseLength>::constant(0.0 * per_m);
    PhaseFunction phase = IsotropicPhase{};  // tabulated; asymmetry() gives its mean cosine
};

InverseLength extinction(const AerosolOptics& aerosol, Wavelength wavelength);
double single_scattering_albedo(const AerosolOptics& aerosol, Wavelength wavelength);

// Runs on all cores: 16 wavelengths take a fraction of a second.
//   relative_humidity  percent, 0 to 99: particles that take up water have grown in it
//   wavelengths        strictly increasing, 250 to 1000 nm
//   log_step           the step of the integral over ln r, size_distribution.h
// Fails, saying what is out of range, if a humidity, a wavelength or a number is; or if there is nothing that scatters.
Result<AerosolOptics> aerosol_optics(AerosolType type, double relative_humidity, std::span<const Wavelength> wavelengths,
                                     double log_step = default_log_step);
Result<AerosolOptics> mixture_optics(std::span<const AerosolShare> mixture, double relative_humidity,
                                     std::span<const Wavelength> wavelengths, double log_step = default_log_step);

// The scattering angles at which the phase functions are tabulated: radians, 0 to pi; dense in the forward peak.
std::vector<double> aerosol_phase_angles();

}  // namespace airlight
