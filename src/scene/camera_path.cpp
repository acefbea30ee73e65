#include "scene/camera_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>

#include "core/files.h"
#include "scene/place_reader.h"
#include "scene/scene.h"
#include "toml/toml_input.h"
#include "units/text.h"

namespace airlight {

namespace {

constexpr double logarithmic_from_m = 10.0;
// Between keys that are farther apart on the sphere, the way would be anything.
constexpr double farthest_apart = 170.0 * deg;

void read_time(TomlInput& key, CameraKey& read) {
    const auto words = key.text("time");
    if (!words) return;
    const Result<Utc> time = parse_utc(*words);
    if (time) read.sky_time = *time;
    else key.refuse("time", time.error().what, time.error().remedy);
}

CameraKey read_key(TomlInput& key) {
    CameraKey read;
    Viewpoint& eye = read.eye;
    keep_within(key, "time_s", key.need(&TomlInput::number, "time_s", "Write the seconds since the path's beginning: time_s = 2.5."), 0.0,
                1e6, "from 0 to 1000000", read.time_s);
    read_place(key, eye);
    read_altitude(key, least_of_camera_m, read.above_ground, read.eye.altitude_m);
    keep_within(key, "pitch", key.angle("pitch"), -90.0 * deg, 90.0 * deg, "from -90 deg to 90 deg", eye.pitch);
    keep_within(key, "field_of_view", key.angle("field_of_view"), 1.0 * deg, 150.0 * deg, "from 1 deg to 150 deg",
                read.vertical_field_of_view);
    read_time(key, read);
    key.refuse_unknown_keys();
    return read;
}

Vec3 place(const CameraKey& key) { return direction_of(key.eye.latitude, key.eye.longitude); }

void check_after(TomlInput& key, const CameraKey& before, const CameraKey& now) {
    if (now.time_s <= before.time_s)
        key.refuse("time_s", fmt::format("it must be after the key before, {}", before.time_s), "Write the keys in their order.");
    if (glm::dot(place(before), place(now)) < std::cos(farthest_apart))
        key.refuse("latitude", "the key before is on the other side of the planet", "Put a key between them.");
    if (before.sky_time && !now.sky_time) key.refuse_missing("time", "The keys before have one: write it in each key, or in none.");
    if (!before.sky_time && now.sky_time) key.refuse("time", "the keys before have none", "Write it in each key, or in none.");
}

// One component over all keys, at a time within the piece [i, i + 1]: Steffen's monotone cubic.
using Component = std::function<double(std::size_t key)>;

double slope_between(const CameraPath& path, const Component& y, std::size_t i) {
    return (y(i + 1) - y(i)) / (path.keys[i + 1].time_s - path.keys[i].time_s);
}

// [Steffen1990, eq. 11]; at the ends the camera begins and ends its way at rest.
double slope_at(const CameraPath& path, const Component& y, std::size_t i) {
    if (i == 0 || i + 1 == path.keys.size()) return 0.0;
    const double before = slope_between(path, y, i - 1), after = slope_between(path, y, i);
    if (before * after <= 0.0) return 0.0;
    const double h0 = path.keys[i].time_s - path.keys[i - 1].time_s, h1 = path.keys[i + 1].time_s - path.keys[i].time_s;
    const double parabola = (before * h1 + after * h0) / (h0 + h1);
    return std::copysign(std::min({2.0 * std::abs(before), 2.0 * std::abs(after), std::abs(parabola)}), before);
}

double between(const CameraPath& path, const Component& y, std::size_t i, double time_s) {
    const double h = path.keys[i + 1].time_s - path.keys[i].time_s, t = (time_s - path.keys[i].time_s) / h;
    const double s0 = h * slope_at(path, y, i), s1 = h * slope_at(path, y, i + 1), y0 = y(i), rise = y(i + 1) - y0;
    return y0 + t * (s0 + t * (3.0 * rise - 2.0 * s0 - s1 + t * (s0 + s1 - 2.0 * rise)));
}

// Headings in which the next is never more than half a turn from the one before.
std::vector<double> unwound(const CameraPath& path) {
    std::vector<double> headings;
    for (const CameraKey& key : path.keys)
        headings.push_back(headings.empty() ? key.eye.heading
                                            : headings.back() + std::remainder(key.eye.heading - headings.back(), 2.0 * pi));
    return headings;
}

}  // namespace

Result<CameraPath> parse_camera_path(std::string_view toml, std::string_view name) {
    const Result<toml::table> table = parse_toml(toml, name, "See docs/camera-path.md.");
    if (!table) return table.error();
    TomlFailure failure{std::string(name), {}};
    TomlInput file(*table, "", failure);
    CameraPath path;
    for (TomlInput& key : file.tables("key")) {
        const CameraKey read = read_key(key);
        if (!failure.first && !path.keys.empty()) check_after(key, path.keys.back(), read);
        path.keys.push_back(read);
    }
    file.refuse_unknown_keys();
    if (path.keys.empty())
        file.refuse_missing("key", "Write [[key]], time_s = 0, latitude = \"46 deg\", longitude = \"8 deg\", altitude = \"3 km\".");
    if (failure.first) return *failure.first;
    return path;
}

Result<CameraPath> read_camera_path(const std::filesystem::path& path) {
    const Result<std::string> text = read_file(path, std::size_t{1} << 24);
    if (!text) return text.error();
    return parse_camera_path(*text, path.string());
}

std::string camera_path_text(const CameraPath& path) {
    std::string text = "# The way of a camera: docs/camera-path.md\n";
    for (const CameraKey& key : path.keys) {
        text += fmt::format(
            "\n[[key]]\ntime_s = {}\nlatitude = \"{}\"\nlongitude = \"{}\"\n{} = \"{}\"\nheading = \"{}\"\npitch = \"{}\"\n"
            "field_of_view = \"{}\"\n",
            key.time_s, angle_text(key.eye.latitude), angle_text(key.eye.longitude), key.above_ground ? "above_ground" : "altitude",
            length_text(key.eye.altitude_m * m), angle_text(key.eye.heading), angle_text(key.eye.pitch),
            angle_text(key.vertical_field_of_view));
        if (key.sky_time) text += fmt::format("time = \"{}\"\n", utc_text(*key.sky_time, 3));
    }
    return text;
}

CameraPath over(const HeightField& ground, CameraPath path) {
    for (CameraKey& key : path.keys) {
        if (key.above_ground) key.eye.altitude_m += surface_m(key.eye, ground);
        key.above_ground = false;
    }
    return path;
}

CameraKey camera_at(const CameraPath& path, double time_s) {
    const std::vector<CameraKey>& keys = path.keys;
    assert(!keys.empty());
    assert(std::ranges::none_of(keys, &CameraKey::above_ground));
    const auto after = std::upper_bound(keys.begin(), keys.end(), time_s, [](double t, const CameraKey& key) { return t < key.time_s; });
    if (after == keys.begin() || after == keys.end()) {
        CameraKey still = after == keys.begin() ? keys.front() : keys.back();
        still.time_s = time_s;
        return still;
    }
    const auto i = static_cast<std::size_t>(after - keys.begin()) - 1;
    const auto at = [&](const Component& component) { return between(path, component, i, time_s); };
    const Vec3 there =
        glm::normalize(Vec3(at([&](std::size_t k) { return place(keys[k]).x; }), at([&](std::size_t k) { return place(keys[k]).y; }),
                            at([&](std::size_t k) { return place(keys[k]).z; })));
    const std::vector<double> headings = unwound(path);
    CameraKey key;
    key.time_s = time_s;
    key.eye.latitude = std::asin(std::clamp(there.z, -1.0, 1.0));
    key.eye.longitude = std::atan2(there.y, there.x);
    key.eye.altitude_m =
        logarithmic_from_m * std::sinh(at([&](std::size_t k) { return std::asinh(keys[k].eye.altitude_m / logarithmic_from_m); }));
    key.eye.heading = std::remainder(at([&](std::size_t k) { return headings[k]; }), 2.0 * pi);
    key.eye.pitch = at([&](std::size_t k) { return keys[k].eye.pitch; });
    key.vertical_field_of_view = at([&](std::size_t k) { return keys[k].vertical_field_of_view; });
    if (const std::optional<Utc>& first = keys.front().sky_time)
        key.sky_time = *airlight::after(*first, at([&](std::size_t k) { return seconds_between(*first, *keys[k].sky_time); }));
    return key;
}

}  // namespace airlight
