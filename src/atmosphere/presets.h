// Atmospheres that come with the program, by name. Their files, data/presets/*.toml, name their sources and are compiled in.
// Uses the file form only.
#pragma once

#include <string_view>
#include <vector>

#include "atmosphere/atmosphere.h"
#include "core/result.h"

namespace airlight {

// "earth-clear", "earth-desert", ..., in the order of the alphabet.
std::vector<std::string_view> preset_names();

// The text of a preset's file. Fails if there is none of this name, naming those that there are.
Result<std::string_view> preset_text(std::string_view name);

// The preset itself.
Result<Atmosphere> preset(std::string_view name);

}  // namespace airlight
