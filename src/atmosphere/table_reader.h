// The parts of a constituent in a file: spectra, density profiles and phase functions.
// The keys: docs/atmosphere-file.md. Private to this module's sources.
#pragma once

#include "atmosphere/atmosphere.h"
#include "toml/toml_input.h"

namespace airlight {

// A number, or { wavelength_nm = [...], value = [...] }.
std::optional<SpectrumOf<Number>> read_numbers(TomlInput& input, std::string_view key);

// "1e-5 1/m", or { wavelength_nm = [...], value_per_m = [...] }.
std::optional<SpectrumOf<InverseLength>> read_coefficients(TomlInput& input, std::string_view key);

// The table `profile`: kind = exponential, layer, triangle or tabulated.
std::optional<DensityProfile> read_profile(TomlInput& input, std::string_view key);

// The table `phase`: kind = isotropic, rayleigh, henyey_greenstein, cornette_shanks or tabulated.
std::optional<PhaseFunction> read_phase(TomlInput& input, std::string_view key);

}  // namespace airlight
