// Where a camera or an object stands, as scenes and keys of paths say it. Uses toml.
#pragma once

#include <optional>
#include <string_view>

#include "toml/toml_input.h"

namespace airlight {

struct Viewpoint;

// Keeps a value within a range; one beyond it is refused by the rule, which says the range in the unit of the file.
void keep_within(TomlInput& input, std::string_view key, std::optional<double> value, double low, double high, std::string_view rule,
                 double& kept);

// "latitude" and "longitude", which must be there, and "heading".
void read_place(TomlInput& input, Viewpoint& place);

// Nearer to the ground a camera may not be said to stand.
inline constexpr double least_of_camera_m = 0.2;

// In metres: "altitude", above 0 m, or "above_ground", above the ground or the sea and not below `least_above_ground_m`; one of them, up to
// 10^9 m.
void read_altitude(TomlInput& input, double least_above_ground_m, bool& above_ground, double& altitude_m);

}  // namespace airlight
