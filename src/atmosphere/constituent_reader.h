// One [[constituent]] of a file, by its kind.
// The keys: docs/atmosphere-file.md. Private to this module's sources.
#pragma once

#include "atmosphere/aerosol.h"
#include "toml/toml_input.h"

namespace airlight {

inline constexpr std::string_view constituent_kinds = "air carbon_dioxide ozone nitrogen_dioxide aerosol generic";

// Any kind but "aerosol".
std::optional<Constituent> read_constituent(TomlInput& input);

// Aerosol, whose amount may depend on the molecules about it.
std::optional<Constituent> read_aerosol(TomlInput& input, const MolecularAir& molecules, Length top);

}  // namespace airlight
