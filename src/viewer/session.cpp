#include "viewer/session.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sun/position.h"
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

void take_sun(Session& session) {
    session.towards_sun = airlight::towards_sun(session.file);
    session.sun_distance_au = session.file.sun.distance_au;
    session.time.reset();
}

// The direction of an azimuth and a zenith angle at the eye's place.
Vec3 direction_over(const Viewpoint& eye, SunAngles angles) {
    return look(
               Viewpoint{
                   .latitude = eye.latitude, .longitude = eye.longitude, .heading = angles.azimuth, .pitch = 0.5 * pi - angles.zenith},
               1.0)
        .forward;
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
    session.air = scene.air;
    if (const Result<Done> taken = take_camera(session, ground); !taken) return taken.error();
    take_sun(session);
    return session;
}

Result<Session> reloaded(const Session& session, const Scene& scene, const HeightField& ground) {
    Session next = session;
    next.file = scene;
    if (!(scene.camera == session.file.camera))
        if (const Result<Done> taken = take_camera(next, ground); !taken) return taken.error();
    if (!(scene.sun == session.file.sun)) take_sun(next);
    if (scene.atmosphere != session.file.atmosphere) next.atmosphere = scene.atmosphere;
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
    scene.air = session.air;
    scene.camera = {.viewpoint = session.eye, .above_ground = false, .vertical_field_of_view = session.field_of_view};
    scene.sun = {.zenith = sun.zenith, .azimuth = sun.azimuth, .distance_au = session.sun_distance_au};
    return scene;
}

SunAngles sun_angles(const Session& session) {
    const Viewpoint& eye = session.eye;
    const Camera level = look(Viewpoint{.latitude = eye.latitude, .longitude = eye.longitude}, 1.0);
    const Vec3 sun = session.towards_sun;
    const double east = glm::dot(sun, level.right), north = glm::dot(sun, level.forward), up = glm::dot(sun, level.up);
    return {std::atan2(std::hypot(east, north), up), std::atan2(east, north)};
}

void place_sun(Session& session, SunAngles angles) {
    session.towards_sun = direction_over(session.eye, angles);
    session.time.reset();
}

void set_time(Session& session, const Utc& time) {
    const Place place{session.eye.latitude, std::remainder(session.eye.longitude, 2.0 * pi), 0.0 * m};
    const SunPosition sun = sun_position(place, time);
    session.towards_sun = direction_over(session.eye, {sun.direction.zenith, sun.direction.azimuth});
    session.sun_distance_au = sun.distance_au;
    session.time = time;
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
