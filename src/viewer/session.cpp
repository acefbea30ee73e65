#include "viewer/session.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "viewer/flight.h"

namespace airlight::viewer {

namespace {

constexpr double slowest_per_s = 0.01, fastest_per_s = 8.0;
constexpr double speed_of_notch = 1.25;

// The file's eye; its altitude is above 0 m, wherever the file counts from.
Result<Done> take_camera(Session& session, const HeightField& ground) {
    const Scene& file = session.file;
    const Result<Camera> camera = airlight::camera_of(file, ground, 1, 1);
    if (!camera) return camera.error();
    session.eye = file.camera.viewpoint;
    session.eye.altitude_m = glm::length(camera->eye) - ground.radius_m;
    session.eye = above_ground(session.eye, ground);
    session.field_of_view = file.camera.vertical_field_of_view;
    return Done{};
}

// What stands above the scene, in the world.
void take_heavens(Session& session, const Scene& scene) {
    session.towards_sun = airlight::towards_sun(scene);
    session.sun_distance_au = scene.sun.distance_au;
    session.moon_m = moon_place(scene);
    session.stars = scene.stars;
    session.time = scene.sun.time;
}

// Whether two files put sun, moon and stars elsewhere; their angles count at the place of the camera.
bool same_heavens(const Scene& a, const Scene& b) {
    const Viewpoint &here = a.camera.viewpoint, &there = b.camera.viewpoint;
    return a.sun == b.sun && a.moon == b.moon && a.stars == b.stars && here.latitude == there.latitude && here.longitude == there.longitude;
}

// The direction of an azimuth and a zenith angle at the eye's place.
Vec3 direction_over(const Viewpoint& eye, SunAngles angles) {
    return look(
               Viewpoint{
                   .latitude = eye.latitude, .longitude = eye.longitude, .heading = angles.azimuth, .pitch = 0.5 * pi - angles.zenith},
               1.0)
        .forward;
}

// The angles of a direction, of any length, at the eye's place.
SunAngles angles_over(const Viewpoint& eye, Vec3 direction) {
    const Camera level = look(Viewpoint{.latitude = eye.latitude, .longitude = eye.longitude}, 1.0);
    const double east = glm::dot(direction, level.right), north = glm::dot(direction, level.forward), up = glm::dot(direction, level.up);
    return {std::atan2(std::hypot(east, north), up), std::atan2(east, north)};
}

// The moon as it stands over the ground under the eye.
MoonScene moon_over(const Viewpoint& eye, Vec3 moon_m, double radius_m) {
    const Vec3 from_ground = moon_m - radius_m * direction_of(eye.latitude, eye.longitude);
    const SunAngles angles = angles_over(eye, from_ground);
    return {angles.zenith, angles.azimuth, glm::length(from_ground)};
}

constexpr std::array all_presets = {
    Preset{"In the grass, midday", 1.7, 4.0 * deg, 35.0 * deg, 70.0 * deg},
    Preset{"In the grass, golden hour", 1.7, 4.0 * deg, 84.0 * deg, 25.0 * deg},
    Preset{"In the grass, after sunset", 1.7, 6.0 * deg, 94.0 * deg, 0.0 * deg},
    Preset{"Over the mountains, 3 km", 3e3, -6.0 * deg, 60.0 * deg, 80.0 * deg},
    Preset{"In the stratosphere, 30 km", 30e3, -4.0 * deg, 70.0 * deg, 60.0 * deg},
    Preset{"In orbit, 400 km", 400e3, -18.0 * deg, 55.0 * deg, 70.0 * deg},
    Preset{"The limb at sunset, 400 km", 400e3, -18.0 * deg, 109.0 * deg, 0.0 * deg},
    Preset{"The planet, 20 000 km", 2e7, -90.0 * deg, 35.0 * deg, 90.0 * deg},
};

}  // namespace

Result<Session> session_of(const Scene& scene, const HeightField& ground) {
    Session session;
    session.file = scene;
    session.atmosphere = scene.atmosphere;
    session.weather = scene.weather;
    session.air = scene.air;
    if (const Result<Done> taken = take_camera(session, ground); !taken) return taken.error();
    take_heavens(session, scene);
    return session;
}

Result<Session> reloaded(const Session& session, const Scene& scene, const HeightField& ground) {
    Session next = session;
    next.file = scene;
    if (!(scene.camera == session.file.camera))
        if (const Result<Done> taken = take_camera(next, ground); !taken) return taken.error();
    if (!same_heavens(scene, session.file)) take_heavens(next, scene);
    if (scene.atmosphere != session.file.atmosphere) next.atmosphere = scene.atmosphere;
    if (scene.weather != session.file.weather) next.weather = scene.weather;
    if (!(scene.air == session.file.air)) next.air = scene.air;
    next.eye = above_ground(next.eye, ground);
    return next;
}

Camera camera_of(const Session& session, int width, int height) {
    Camera camera = look(session.eye, session.file.ground.radius_m);
    camera.vertical_field_of_view = session.field_of_view;
    camera.width = width, camera.height = height;
    return camera;
}

Scene scene_of(const Session& session) {
    Scene scene = session.file;
    const SunAngles sun = sun_angles(session);
    scene.atmosphere = session.atmosphere;
    scene.weather = session.weather;
    scene.air = session.air;
    scene.camera = {.viewpoint = session.eye, .above_ground = false, .vertical_field_of_view = session.field_of_view};
    scene.sun = {.zenith = sun.zenith, .azimuth = sun.azimuth, .distance_au = session.sun_distance_au, .time = session.time};
    scene.moon.reset();
    if (session.moon_m) scene.moon = moon_over(session.eye, *session.moon_m, scene.ground.radius_m);
    scene.stars = session.stars;
    return scene;
}

SunAngles sun_angles(const Session& session) { return angles_over(session.eye, session.towards_sun); }

void place_sun(Session& session, SunAngles angles) {
    session.towards_sun = direction_over(session.eye, angles);
    session.time.reset();
}

void set_time(Session& session, const Utc& time) {
    Scene scene = scene_of(session);
    airlight::set_time(scene, time);
    take_heavens(session, scene);
}

void change_speed(Session& session, double notches) {
    session.flown_per_s = std::clamp(session.flown_per_s * std::pow(speed_of_notch, notches), slowest_per_s, fastest_per_s);
}

std::span<const Preset> presets() { return all_presets; }

void go_to(Session& session, const Preset& preset, const HeightField& ground) {
    session.eye.altitude_m = surface_m(session.eye, ground) + preset.height_m;
    session.eye.pitch = preset.pitch;
    session.eye = above_ground(session.eye, ground);
    place_sun(session, {preset.sun_zenith, session.eye.heading + preset.sun_from_view});
}

}  // namespace airlight::viewer
