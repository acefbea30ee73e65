#include <fmt/format.h>

#include <cmath>

#include "core/files.h"
#include "scene/object_reader.h"
#include "scene/place_reader.h"
#include "scene/scene.h"
#include "toml/toml_input.h"

namespace airlight {

namespace {

std::optional<double> metres(std::optional<Length> length) {
    if (!length) return {};
    return length->in(m);
}

void read_air(TomlInput& file, Scene& scene) {
    auto air = file.table("air");
    if (!air) return;
    if (const auto word = air->text("method")) {
        if (const auto method = air_method_named(*word)) scene.air.method = *method;
        else air->refuse_word("method", air_method_names);
    }
    if (const auto word = air->text("shafts")) {
        if (const auto shafts = shafts_named(*word)) scene.air.shafts = *shafts;
        else air->refuse_word("shafts", shafts_names);
    }
    air->refuse_unknown_keys();
}

void read_ground(TomlInput& file, Scene& scene, const std::filesystem::path& folder) {
    auto ground = file.table("ground");
    if (!ground) return;
    if (const auto path = ground->text("elevation")) scene.ground.elevation = folder / *path;
    if (const auto path = ground->text("surface")) scene.ground.surface = folder / *path;
    keep_within(*ground, "radius", metres(ground->length("radius")), 1e5, 1e8, "from 100 km to 100000 km", scene.ground.radius_m);
    if (const auto sea = ground->truth("sea")) scene.ground.sea = *sea;
    double seed = 1.0;
    keep_within(*ground, "seed", ground->number("seed"), 1.0, 1e6, "from 1 to 1000000", seed);
    if (seed != std::floor(seed)) ground->refuse("seed", "it must be a whole number", "");
    scene.ground.seed = static_cast<std::uint32_t>(seed);
    ground->refuse_unknown_keys();
}

void read_camera(TomlInput& file, Scene& scene) {
    auto camera = file.table("camera");
    if (!camera) {
        if (!file.has("camera"))
            file.refuse_missing("camera", "Write [camera], latitude = \"46 deg\", longitude = \"8 deg\", altitude = \"3 km\".");
        return;
    }
    CameraScene& c = scene.camera;
    read_place(*camera, c.viewpoint);
    read_altitude(*camera, least_of_camera_m, c.above_ground, c.viewpoint.altitude_m);
    keep_within(*camera, "pitch", camera->angle("pitch"), -90.0 * deg, 90.0 * deg, "from -90 deg to 90 deg", c.viewpoint.pitch);
    keep_within(*camera, "field_of_view", camera->angle("field_of_view"), 1.0 * deg, 150.0 * deg, "from 1 deg to 150 deg",
                c.vertical_field_of_view);
    camera->refuse_unknown_keys();
}

Result<Utc> moment(TomlInput& table) {
    const auto words = table.text("time");
    if (!words) return Error{};
    Result<Utc> time = parse_utc(*words);
    if (!time) table.refuse("time", time.error().what, time.error().remedy);
    return time;
}

void refuse_beside_time(TomlInput& table, std::string_view what) {
    for (const char* key : {"zenith", "azimuth"})
        if (table.has(key))
            table.refuse(key, fmt::format("time is given as well, which says where the {} stands", what), "Keep one of them.");
}

void read_angles(TomlInput& table, double& zenith, double& azimuth) {
    keep_within(table, "zenith", table.angle("zenith"), 0.0, pi, "from 0 deg to 180 deg", zenith);
    keep_within(table, "azimuth", table.angle("azimuth"), -360.0 * deg, 360.0 * deg, "from -360 deg to 360 deg", azimuth);
}

void read_sun(TomlInput& file, Scene& scene) {
    auto sun = file.table("sun");
    if (!sun) return;
    if (sun->has("time")) {
        refuse_beside_time(*sun, "sun");
        if (const Result<Utc> time = moment(*sun)) set_time(scene, *time);
    } else read_angles(*sun, scene.sun.zenith, scene.sun.azimuth);
    sun->refuse_unknown_keys();
}

// Whether the scene shows what the table is about.
bool visible(TomlInput& table) { return table.truth("visible").value_or(true); }

void read_moon(TomlInput& file, Scene& scene) {
    auto moon = file.table("moon");
    if (!moon) return;
    MoonScene place = scene.moon.value_or(MoonScene{45.0 * deg, 180.0 * deg, 384400e3});
    read_angles(*moon, place.zenith, place.azimuth);
    keep_within(*moon, "distance", metres(moon->length("distance")), 1e7, 1e10, "from 10000 km to 10000000 km", place.distance_m);
    scene.moon = place;
    scene.shows_moon = visible(*moon);
    if (!scene.shows_moon) scene.moon.reset();
    moon->refuse_unknown_keys();
}

void read_stars(TomlInput& file, Scene& scene) {
    auto stars = file.table("stars");
    if (!stars) return;
    scene.shows_stars = visible(*stars);
    if (stars->has("time")) {
        if (const Result<Utc> time = moment(*stars)) scene.stars = StarScene{*time};
    } else if (!scene.stars && scene.shows_stars) stars->refuse_missing("time", "Write time = \"2024-06-21T22:00:00Z\", here or in [sun].");
    double faintest = 6.0;
    keep_within(*stars, "faintest", stars->number("faintest"), -2.0, 6.0, "a magnitude from -2 to 6", faintest);
    if (scene.stars) scene.stars->faintest = faintest;
    if (!scene.shows_stars) scene.stars.reset();
    stars->refuse_unknown_keys();
}

}  // namespace

Result<Scene> parse_scene(std::string_view toml, std::string_view name) {
    const Result<toml::table> table = parse_toml(toml, name, "See docs/scene-file.md.");
    if (!table) return table.error();
    TomlFailure failure{std::string(name), {}};
    TomlInput file(*table, "", failure);
    Scene scene;
    scene.file = name;
    if (const auto air = file.text("atmosphere")) scene.atmosphere = *air;
    if (const auto report = file.text("weather")) scene.weather = *report;
    read_air(file, scene);
    read_ground(file, scene, std::filesystem::path(name).parent_path());
    read_camera(file, scene);
    if (!failure.first) read_sun(file, scene), read_moon(file, scene), read_stars(file, scene);
    else file.has("sun"), file.has("moon"), file.has("stars");
    scene.objects = read_objects(file, std::filesystem::path(name).parent_path());
    file.refuse_unknown_keys();
    if (failure.first) return *failure.first;
    return scene;
}

Result<Scene> read_scene(const std::filesystem::path& path) {
    const Result<std::string> text = read_file(path, std::size_t{1} << 20);
    if (!text) return text.error();
    return parse_scene(*text, path.string());
}

}  // namespace airlight
