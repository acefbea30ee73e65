#include "scene/altitude_reader.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>

namespace airlight {

void read_altitude(TomlInput& input, bool& above_ground, double& altitude_m) {
    constexpr double farthest_m = 1e9;
    above_ground = input.has("above_ground");
    if (above_ground == input.has("altitude")) {
        if (above_ground) input.refuse("altitude", "above_ground is given as well", "Keep one of them.");
        else input.refuse_missing("altitude", "Write altitude = \"3 km\" (above 0 m), or above_ground = \"2 m\".");
        return;
    }
    const std::string_view key = above_ground ? "above_ground" : "altitude";
    const double least = above_ground ? 0.2 : -1e5;
    const std::optional<Length> height = input.length(key);
    if (!height) return;
    const double read_m = height->in(m);
    if (read_m < least || read_m > farthest_m) input.refuse(key, fmt::format("it must be from {} m to 1000000 km", least), "");
    else altitude_m = read_m;
}

}  // namespace airlight
