#include "scene/place_reader.h"

#include <fmt/format.h>

#include "camera/camera.h"

namespace airlight {

void keep_within(TomlInput& input, std::string_view key, std::optional<double> value, double low, double high, std::string_view rule,
                 double& kept) {
    if (!value) return;
    if (*value < low || *value > high) input.refuse(key, fmt::format("it must be {}", rule), "");
    else kept = *value;
}

void read_place(TomlInput& input, Viewpoint& place) {
    for (const auto& [key, remedy] :
         {std::pair{"latitude", "North is positive: \"46 deg\"."}, {"longitude", "East is positive: \"8 deg\"."}})
        if (!input.has(key)) input.refuse_missing(key, remedy);
    keep_within(input, "latitude", input.angle("latitude"), -90.0 * deg, 90.0 * deg, "from -90 deg to 90 deg", place.latitude);
    keep_within(input, "longitude", input.angle("longitude"), -180.0 * deg, 360.0 * deg, "from -180 deg to 360 deg", place.longitude);
    keep_within(input, "heading", input.angle("heading"), -360.0 * deg, 360.0 * deg, "from -360 deg to 360 deg", place.heading);
}

void read_altitude(TomlInput& input, double least_above_ground_m, bool& above_ground, double& altitude_m) {
    constexpr double farthest_m = 1e9;
    above_ground = input.has("above_ground");
    if (above_ground == input.has("altitude")) {
        if (above_ground) input.refuse("altitude", "above_ground is given as well", "Keep one of them.");
        else input.refuse_missing("altitude", "Write altitude = \"3 km\" (above 0 m), or above_ground = \"2 m\".");
        return;
    }
    const std::string_view key = above_ground ? "above_ground" : "altitude";
    const double least = above_ground ? least_above_ground_m : -1e5;
    const std::optional<Length> height = input.length(key);
    if (!height) return;
    const double read_m = height->in(m);
    if (read_m < least || read_m > farthest_m) input.refuse(key, fmt::format("it must be from {} m to 1000000 km", least), "");
    else altitude_m = read_m;
}

}  // namespace airlight
