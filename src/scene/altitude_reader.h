// How high a camera stands, as scenes and keys of paths say it. Uses toml.
#pragma once

#include "toml/toml_input.h"

namespace airlight {

// In metres: "altitude", above 0 m, or "above_ground", above the ground or the sea; one of them, up to 10^9 m.
void read_altitude(TomlInput& input, bool& above_ground, double& altitude_m);

}  // namespace airlight
