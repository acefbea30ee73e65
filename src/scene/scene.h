// What a picture shows: a ground, objects, a camera, a sun, a moon and stars, as a person writes them down. docs/scene-file.md.
// Uses camera, sun, celestial, terrain and objects; knows no GPU.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "camera/camera.h"
#include "celestial/stars.h"
#include "core/result.h"
#include "objects/object.h"
#include "scene/object_scene.h"
#include "terrain/height_field.h"
#include "terrain/surface_image.h"

namespace airlight {

struct GroundScene {
    std::optional<std::filesystem::path> elevation;  // a raster; else octaves of noise
    std::optional<std::filesystem::path> surface;    // an image of the planet; else colours by height, slope and latitude
    double radius_m = 6'371'000.0;
    bool sea = true;  // what lies below 0 m is under water
    std::uint32_t seed = 1;

    friend bool operator==(const GroundScene&, const GroundScene&) = default;
};

struct CameraScene {
    Viewpoint viewpoint;        // its altitude is above 0 m
    bool above_ground = false;  // then above the ground, or the sea, instead
    double vertical_field_of_view = 60.0 * deg;

    friend bool operator==(const CameraScene&, const CameraScene&) = default;
};

// As seen from the camera's place.
struct SunScene {
    double zenith = 45.0 * deg;
    double azimuth = 180.0 * deg;
    double distance_au = 1.0;
    std::optional<Utc> time = {};  // when it stands there; none: it was placed by its angles

    friend bool operator==(const SunScene&, const SunScene&) = default;
};

// How the light of the air is computed: docs/decisions/0010-air-methods.md.
enum class AirMethodName { airlight, hillaire2020, bruneton2008, exact };
inline constexpr std::string_view air_method_names = "airlight hillaire2020 bruneton2008 exact";
std::optional<AirMethodName> air_method_named(std::string_view name);

// How the parts of the air that lie in the ground's shadow are found: docs/decisions/0013-shadows.md. `none` leaves out these, not the
// shadows on the ground.
enum class ShaftsName { epipolar, marched, planes, volumes, brute, none };
inline constexpr std::string_view shafts_names = "epipolar marched planes volumes brute none";
std::optional<ShaftsName> shafts_named(std::string_view name);

struct AirScene {
    AirMethodName method = AirMethodName::airlight;
    ShaftsName shafts = ShaftsName::epipolar;

    friend bool operator==(const AirScene&, const AirScene&) = default;
};

// As seen from the camera's place; its phase follows from where the sun stands.
struct MoonScene {
    double zenith;
    double azimuth;
    double distance_m;

    friend bool operator==(const MoonScene&, const MoonScene&) = default;
};

// Those that stand over the Earth at a moment.
struct StarScene {
    Utc time;
    double faintest = 6.0;  // magnitude

    friend bool operator==(const StarScene&, const StarScene&) = default;
};

struct Scene {
    std::string file;                        // for messages
    std::string atmosphere = "earth-clear";  // a preset or a file, its path relative to that of the scene; "none" is no air
    std::string weather;                     // a METAR report, or a file with one, as above; empty: as the atmosphere is by itself
    AirScene air;
    GroundScene ground;
    std::vector<ObjectScene> objects;
    CameraScene camera;
    SunScene sun;
    std::optional<MoonScene> moon;
    std::optional<StarScene> stars;
    bool shows_moon = true, shows_stars = true;  // false: none at any time
};

// The scene of a TOML text; paths in it are relative to the folder of `file`. Fails with file, line, key, value, the rule and what to do.
Result<Scene> parse_scene(std::string_view toml, std::string_view file);
Result<Scene> read_scene(const std::filesystem::path& path);

// Places sun, moon and stars as they stand over the camera's place at a moment; what the scene does not show stays hidden.
void set_time(Scene& scene, const Utc& time);

// Fails as Raster::open() does.
Result<HeightField> ground_of(const Scene& scene);

// Fails as surface_image() does.
Result<GroundColour> colour_of(const Scene& scene);

// The scene's objects where they stand. Fails as read_mesh() does.
Result<std::vector<Object>> objects_of(const Scene& scene, const HeightField& ground);

// The height of the ground, or of the sea above it, at a place, in metres.
double surface_m(const Viewpoint& place, const HeightField& ground);

// Fails if the camera would be in the ground.
Result<Camera> camera_of(const Scene& scene, const HeightField& ground, int width, int height);

// Of length one, along the axes of the world.
Vec3 towards_sun(const Scene& scene);

// The moon's centre, in metres from the planet's: from the ground under the camera it stands where the scene says.
std::optional<Vec3> moon_place(const Scene& scene);

// None if the scene has none.
std::vector<Star> stars_of(const Scene& scene);

}  // namespace airlight
