#include "scene/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sun/position.h"
#include "terrain/raster_relief.h"

namespace airlight {

std::optional<AirMethodName> air_method_named(std::string_view name) {
    if (name == "airlight") return AirMethodName::airlight;
    if (name == "hillaire2020") return AirMethodName::hillaire2020;
    if (name == "bruneton2008") return AirMethodName::bruneton2008;
    if (name == "exact") return AirMethodName::exact;
    return std::nullopt;
}

std::optional<ShaftsName> shafts_named(std::string_view name) {
    if (name == "epipolar") return ShaftsName::epipolar;
    if (name == "marched") return ShaftsName::marched;
    if (name == "planes") return ShaftsName::planes;
    if (name == "volumes") return ShaftsName::volumes;
    if (name == "brute") return ShaftsName::brute;
    if (name == "none") return ShaftsName::none;
    return {};
}

namespace {

// Over the camera's place.
Vec3 direction_over(const Scene& scene, double zenith, double azimuth) {
    Viewpoint level = scene.camera.viewpoint;
    level.heading = azimuth, level.pitch = 0.5 * pi - zenith;
    return look(level, scene.ground.radius_m).forward;
}

}  // namespace

Result<HeightField> ground_of(const Scene& scene) {
    const GroundScene& g = scene.ground;
    if (!g.elevation) {
        ProceduralRelief relief{.radius_m = g.radius_m, .sea = g.sea};
        relief.continents.seed += 2 * (g.seed - 1), relief.mountains.seed += 2 * (g.seed - 1);
        return procedural_height(relief);
    }
    Result<std::shared_ptr<const Raster>> raster = Raster::open(*g.elevation);
    if (!raster) return raster.error();
    return raster_height(*raster, {.radius_m = g.radius_m, .sea = g.sea, .seed = g.seed}, level_height(g.radius_m));
}

Result<GroundColour> colour_of(const Scene& scene) {
    if (scene.ground.surface) return surface_image(*scene.ground.surface);
    return GroundColour{};
}

double surface_m(const Viewpoint& place, const HeightField& ground) {
    // Heights count all features; how wide those of the slope are does not matter here.
    const double height = ground.sample(direction_of(place.latitude, place.longitude), 1.0).height_m;
    return ground.sea ? std::max(height, 0.0) : height;
}

Result<Camera> camera_of(const Scene& scene, const HeightField& ground, int width, int height) {
    Viewpoint view = scene.camera.viewpoint;
    const double surface = surface_m(view, ground);
    if (scene.camera.above_ground) view.altitude_m += surface;
    if (view.altitude_m <= surface)
        return Error{scene.file,
                     fmt::format("camera.altitude = \"{:.1f} m\" is in the ground, which is at {:.1f} m there.", view.altitude_m, surface),
                     "Write a larger one, or camera.above_ground."};
    Camera camera = look(view, ground.radius_m);
    camera.vertical_field_of_view = scene.camera.vertical_field_of_view;
    camera.width = width, camera.height = height;
    return camera;
}

void set_time(Scene& scene, const Utc& time) {
    const Viewpoint& at = scene.camera.viewpoint;
    const Place place{at.latitude, std::remainder(at.longitude, 2.0 * pi), 0.0 * m};
    const SunPosition sun = sun_position(place, time);
    const MoonPosition moon = moon_position(place, time);
    scene.sun = {sun.direction.zenith, sun.direction.azimuth, sun.distance_au, time};
    scene.moon.reset();
    if (scene.shows_moon) scene.moon = MoonScene{moon.direction.zenith, moon.direction.azimuth, moon.distance.in(m)};
    const double faintest = scene.stars.value_or(StarScene{}).faintest;
    scene.stars.reset();
    if (scene.shows_stars) scene.stars = StarScene{time, faintest};
}

Vec3 towards_sun(const Scene& scene) { return direction_over(scene, scene.sun.zenith, scene.sun.azimuth); }

std::optional<Vec3> moon_place(const Scene& scene) {
    if (!scene.moon) return std::nullopt;
    const Viewpoint& at = scene.camera.viewpoint;
    return scene.ground.radius_m * direction_of(at.latitude, at.longitude) +
           scene.moon->distance_m * direction_over(scene, scene.moon->zenith, scene.moon->azimuth);
}

std::vector<Star> stars_of(const Scene& scene) {
    if (!scene.stars) return {};
    return stars_at(scene.stars->time, scene.stars->faintest);
}

}  // namespace airlight
