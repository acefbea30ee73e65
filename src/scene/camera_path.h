// How a camera moves: keys in a text file, and what lies between them. docs/camera-path.md.
// Uses camera, sun and terrain; knows no GPU.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "camera/camera.h"
#include "core/result.h"
#include "sun/time.h"
#include "terrain/height_field.h"

namespace airlight {

// Where the camera is at a moment, and what it sees.
struct CameraKey {
    double time_s = 0.0;
    Viewpoint eye;  // its altitude is above 0 m
    double vertical_field_of_view = 60.0 * deg;
    bool above_ground = false;         // the altitude is above the ground, or the sea, instead
    std::optional<Utc> sky_time = {};  // when sun, moon and stars stand as they do then

    friend bool operator==(const CameraKey&, const CameraKey&) = default;
};

// At least one key; times rise from key to key. All of them have a sky_time, or none.
struct CameraPath {
    std::vector<CameraKey> keys;

    double begin_s() const { return keys.front().time_s; }
    double end_s() const { return keys.back().time_s; }
    friend bool operator==(const CameraPath&, const CameraPath&) = default;
};

// The path of a TOML text. Fails with file, line, key, value, the rule and what to do.
Result<CameraPath> parse_camera_path(std::string_view toml, std::string_view file);
Result<CameraPath> read_camera_path(const std::filesystem::path& path);

// The text that reads back to the same path, but for sky_time, which is cut to a millisecond.
std::string camera_path_text(const CameraPath& path);

// The path whose altitudes are all above 0 m.
CameraPath over(const HeightField& ground, CameraPath path);

// The camera at a moment, on a path whose altitudes are all above 0 m; before the first key and after the last it stands still. Between two keys nothing goes beyond them: altitude,
// angles and the place glide with a speed that does not jump, by cubics that are monotone [Steffen1990]. Altitude does so on a scale
// that is logarithmic from some 10 m on, so that a way from space to the grass is even; the heading takes the shorter way around. The
// sky's time glides alike.
CameraKey camera_at(const CameraPath& path, double time_s);

}  // namespace airlight
