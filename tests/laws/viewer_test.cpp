// The viewer without its window: flight, the sun, files that change.

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <random>

#include "core/files.h"
#include "terrain/cube_sphere.h"
#include "terrain/procedural_relief.h"
#include "tools/temporary_folder.h"
#include "viewer/file_watch.h"
#include "viewer/files.h"
#include "viewer/flight.h"
#include "viewer/path_edit.h"
#include "viewer/probe.h"
#include "viewer/session.h"
#include "viewer/slices.h"

using namespace airlight;
using namespace airlight::test;
using namespace airlight::viewer;

namespace {

constexpr const char* toml =
    "atmosphere = \"earth-clear\"\n[camera]\nlatitude = \"46 deg\"\nlongitude = \"8 deg\"\naltitude = \"20 km\"\nheading = \"120 deg\"\n";

// A sphere without features, as the sea would be.
HeightField smooth() {
    return {.radius_m = 6.371e6,
            .sample = [](Vec3, double) { return HeightSample{}; },
            .range = [](const Cap&) { return Interval{}; },
            .detail = [](double) { return 0.0; },
            .whole = {}};
}

Scene scene_of(const std::string& text) {
    const Result<Scene> scene = parse_scene(text, "scene.toml");
    if (!scene) FAIL(scene.error().message());
    return *scene;
}

Vec3 forward(const Viewpoint& eye) { return look(eye, 1.0).forward; }

}  // namespace

TEST_CASE("an eye that falls loses the same share of its height each second, from 20 000 km to a person's height") {
    const HeightField ground = smooth();
    Viewpoint eye{.latitude = 0.8, .longitude = 0.1, .altitude_m = 2e7, .pitch = -0.5 * pi};
    const double seconds = 2.0;
    for (int i = 0; i < 7; ++i) {
        const double before = eye.altitude_m;
        eye = flown(eye, {.forward = 1.0}, 0.5, seconds, ground);
        CHECK(eye.altitude_m == doctest::Approx(before * std::exp(-0.5 * seconds)).epsilon(2e-3));
    }
    eye = flown(eye, {.forward = 1.0}, 0.5, 60.0, ground);
    CHECK(eye.altitude_m == lowest_eye_m);
    CHECK(eye.latitude == doctest::Approx(0.8));
}

TEST_CASE("what is flown does not depend on the rate of frames") {
    const HeightField ground = smooth();
    const Viewpoint start{.latitude = 0.8, .longitude = 0.1, .altitude_m = 5e4, .heading = 1.0, .pitch = -0.2};
    const Steering steering{.forward = 1.0, .right = 0.4, .up = -0.1};
    const Viewpoint once = flown(start, steering, 0.7, 3.0, ground);
    for (const int frames : {7, 180, 1000}) {
        Viewpoint eye = start;
        for (int i = 0; i < frames; ++i) eye = flown(eye, steering, 0.7, 3.0 / frames, ground);
        CHECK(eye.altitude_m == doctest::Approx(once.altitude_m).epsilon(1e-3));
        CHECK(angle_between(direction_of(eye.latitude, eye.longitude), direction_of(once.latitude, once.longitude)) * 6.371e6 < 1e-3 * 5e4);
    }
}

TEST_CASE("an eye that looks level flies along a great circle, over the pole as well, and around the planet to where it was") {
    const HeightField ground = smooth();
    const double height = 1e6;
    // North along a meridian; and a circle that passes within a degree of the pole.
    for (const double heading : {0.0, 1.3 * deg}) {
        const Viewpoint start{.latitude = 0.7, .longitude = 0.3, .altitude_m = height, .heading = heading};
        const Vec3 pole = glm::cross(direction_of(0.7, 0.3), forward(start));
        Viewpoint eye = start;
        // Sunk as fast as a straight way rises, so that the height stays.
        double farthest = 0.0, way = 0.0;
        while (way < 2.0 * pi) {
            const Vec3 before = direction_of(eye.latitude, eye.longitude);
            eye = flown(eye, {.forward = 1.0}, 0.5, 0.02, ground);
            eye.altitude_m = height;
            const Vec3 here = direction_of(eye.latitude, eye.longitude);
            way += angle_between(before, here);
            farthest = std::max(farthest, std::abs(glm::dot(here, pole)));
        }
        CHECK(farthest < 1e-9);
        CHECK(angle_between(direction_of(eye.latitude, eye.longitude), direction_of(0.7, 0.3)) < 0.01);
        CHECK(eye.pitch == 0.0);
        CHECK(angle_between(forward(eye), forward(start)) < 0.01);
    }
}

TEST_CASE("no flight leads into the ground or the sea") {
    const HeightField ground = procedural_height({});
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (int flight = 0; flight < 20; ++flight) {
        Viewpoint eye = above_ground({.latitude = 1.5 * any(random), .longitude = pi * any(random), .altitude_m = -1e4}, ground);
        CHECK(height_m(eye, ground) == doctest::Approx(lowest_eye_m).epsilon(1e-6));
        for (int frame = 0; frame < 20; ++frame) {
            eye = turned(eye, any(random), any(random));
            eye = flown(eye, {any(random), any(random), any(random) - 0.5}, 2.0, 0.05, ground);
            CHECK(height_m(eye, ground) >= lowest_eye_m - 1e-6);
            CHECK(eye.altitude_m >= lowest_eye_m - 1e-6);  // the sea
        }
    }
}

TEST_CASE("an eye without steering stays, to the bit, a turn ends straight up and straight down") {
    const Viewpoint eye{.latitude = 0.1, .longitude = 0.2, .altitude_m = 10.0, .heading = 3.0, .pitch = 0.1};
    CHECK(flown(eye, {}, 0.5, 10.0, smooth()) == eye);
    CHECK(turned(eye, 0.0, 9.0).pitch == 0.5 * pi);
    CHECK(turned(eye, 0.0, -9.0).pitch == -0.5 * pi);
    CHECK(std::abs(turned(eye, 2.0, 0.0).heading - (5.0 - 2.0 * pi)) < 1e-12);
    // Straight down, forward is down and the heading is kept.
    const Viewpoint down = flown(turned(eye, 0.0, -9.0), {.forward = 1.0}, 0.5, 0.5, smooth());
    CHECK(down.altitude_m < 10.0);
    CHECK(down.heading == doctest::Approx(3.0).epsilon(1e-6));
}

TEST_CASE("a session begins as its file says: the eye, the sun and the air") {
    const HeightField ground = smooth();
    const Scene scene = scene_of(std::string(toml) + "field_of_view = \"40 deg\"\n[sun]\nzenith = \"70 deg\"\nazimuth = \"250 deg\"\n");
    const Result<Session> session = session_of(scene, ground);
    REQUIRE(session);
    CHECK(glm::length(camera_of(*session, 64, 36).eye - airlight::camera_of(scene, ground, 64, 36)->eye) < 1e-6);
    CHECK(glm::length(camera_of(*session, 64, 36).forward - airlight::camera_of(scene, ground, 64, 36)->forward) < 1e-12);
    CHECK(camera_of(*session, 64, 36).vertical_field_of_view == doctest::Approx(40.0 * deg));
    CHECK(sun_angles(*session).zenith == doctest::Approx(70.0 * deg));
    CHECK(sun_angles(*session).azimuth == doctest::Approx(-110.0 * deg));
    CHECK(session->atmosphere == "earth-clear");
    CHECK(!session_of(scene_of("[camera]\nlatitude = \"0 deg\"\nlongitude = \"0 deg\"\naltitude = \"-5 m\"\n"), ground));
}

TEST_CASE("the sun stands in the world: an eye that flies a quarter around the planet sees it elsewhere") {
    Session session = *session_of(scene_of(toml), smooth());
    session.eye.latitude = 0.0, session.eye.longitude = 0.0;
    place_sun(session, {30.0 * deg, 90.0 * deg});  // east
    CHECK(sun_angles(session).zenith == doctest::Approx(30.0 * deg));
    session.eye.longitude = 90.0 * deg;
    CHECK(sun_angles(session).zenith == doctest::Approx(60.0 * deg));
    CHECK(sun_angles(session).azimuth == doctest::Approx(-90.0 * deg));
}

TEST_CASE("twelve hours turn the sun around the axis of the planet, at noon of the equinox it stands over the equator") {
    Session session = *session_of(scene_of(toml), smooth());
    set_time(session, *parse_utc("2024-03-20T12:00:00Z"));
    CHECK(angle_between(session.towards_sun, direction_of(0.0, 0.0)) < 2.5 * deg);
    const Vec3 noon = session.towards_sun;
    session.eye.longitude = -2.0;  // wherever the eye is, but for parallax
    set_time(session, *parse_utc("2024-03-20T12:00:00Z"));
    CHECK(angle_between(session.towards_sun, noon) < 0.01 * deg);
    set_time(session, *parse_utc("2024-03-21T00:00:00Z"));
    CHECK(angle_between(session.towards_sun, Vec3(-noon.x, -noon.y, noon.z)) < 0.3 * deg);
    CHECK(session.time == *parse_utc("2024-03-21T00:00:00Z"));
    place_sun(session, {1.0, 1.0});
    CHECK(!session.time);
}

TEST_CASE("a session begins at its file's time, and shows the file's moon and stars") {
    const Scene file = scene_of(std::string(toml) + "[sun]\ntime = \"2024-04-08T18:17:20Z\"\n[stars]\nfaintest = 3\n");
    const Session session = *session_of(file, smooth());
    CHECK(session.time == *parse_utc("2024-04-08T18:17:20Z"));
    CHECK(glm::length(*session.moon_m - *moon_place(file)) < 1.0);
    CHECK(stars_of(viewer::scene_of(session)).size() == stars_of(file).size());
    CHECK(!session_of(scene_of(toml), smooth())->time);
}

TEST_CASE("moon and stars stand in the heavens: an eye that flies on leaves them where they are") {
    Session session = *session_of(scene_of(std::string(toml) + "[moon]\nzenith = \"30 deg\"\nazimuth = \"200 deg\"\n"), smooth());
    const Vec3 moon = *session.moon_m;
    session.eye = {.latitude = -0.6, .longitude = 2.0, .altitude_m = 4e6};
    const Scene there = viewer::scene_of(session);
    CHECK(glm::length(*moon_place(there) - moon) < 1.0);
    CHECK(glm::length(towards_sun(there) - session.towards_sun) < 1e-12);
    // What a menu does to the sun is not the moon's.
    place_sun(session, {1.0, 1.0});
    CHECK(*session.moon_m == moon);
}

TEST_CASE("a time moves sun, moon and stars together, to where a file with that time puts them") {
    const std::string time = "2024-04-08T18:17:20Z";
    Session session = *session_of(scene_of(std::string(toml) + "[sun]\ntime = \"2023-01-01T00:00Z\"\n"), smooth());
    set_time(session, *parse_utc(time));
    const Scene file = scene_of(std::string(toml) + "[sun]\ntime = \"" + time + "\"\n"), become = viewer::scene_of(session);
    CHECK(glm::length(towards_sun(become) - towards_sun(file)) < 1e-12);
    CHECK(become.sun.distance_au == file.sun.distance_au);
    CHECK(glm::length(*moon_place(become) - *moon_place(file)) < 1.0);
    CHECK(become.stars == file.stars);
    Session hidden = *session_of(scene_of(std::string(toml) + "[moon]\nvisible = false\n[stars]\nvisible = false\n"), smooth());
    set_time(hidden, *parse_utc(time));
    CHECK(!moon_place(viewer::scene_of(hidden)));
    CHECK(stars_of(viewer::scene_of(hidden)).empty());
}

TEST_CASE("a file that is written anew with ground above the eye lifts it, one that moves the moon moves it") {
    const HeightField ground = smooth();
    Session session = *session_of(scene_of(toml), ground);
    HeightField higher = ground;
    higher.sample = [](Vec3, double) { return HeightSample{30e3, {}, {}, {}}; };
    const Result<Session> lifted = reloaded(session, scene_of(std::string(toml) + "[ground]\nseed = 2\n"), higher);
    REQUIRE(lifted);
    CHECK(height_m(lifted->eye, higher) == doctest::Approx(lowest_eye_m));
    const Scene moon = scene_of(std::string(toml) + "[moon]\nzenith = \"20 deg\"\n");
    CHECK(reloaded(session, moon, ground)->moon_m == moon_place(moon));
}

TEST_CASE("a file that is written anew changes what it says otherwise, and leaves what the user did") {
    const HeightField ground = smooth();
    Session session = *session_of(scene_of(toml), ground);
    session.eye.altitude_m = 5.0;
    session.look.ev100 = 9.0;
    place_sun(session, {20.0 * deg, 0.0});
    const std::string other_air = std::string(toml).replace(0, std::string("atmosphere = \"earth-clear\"").size(), "atmosphere = \"mars\"");
    const Session air = *reloaded(session, scene_of(other_air), ground);
    CHECK(air.atmosphere == "mars");
    CHECK(air.eye == session.eye);
    session.air.method = AirMethodName::exact;
    CHECK(reloaded(session, scene_of(other_air), ground)->air.method == AirMethodName::exact);
    CHECK(air.towards_sun == session.towards_sun);
    const Session sun = *reloaded(session, scene_of(std::string(toml) + "[sun]\nzenith = \"80 deg\"\n"), ground);
    CHECK(sun_angles(sun).zenith == doctest::Approx(80.0 * deg));
    CHECK(sun.eye == session.eye);
    const Session eye = *reloaded(session, scene_of(std::string(toml) + "pitch = \"3 deg\"\n"), ground);
    CHECK(eye.eye.altitude_m == doctest::Approx(20e3));
    CHECK(eye.towards_sun == session.towards_sun);
    CHECK(eye.look == session.look);
    const std::string buried = std::string(toml).replace(std::string(toml).find("20 km"), 5, "-9 km");
    CHECK(!reloaded(session, scene_of(buried), ground));
}

TEST_CASE("each preset puts the eye at its height and the sun where it says, whatever the place") {
    const HeightField ground = procedural_height({});
    Session session = *session_of(scene_of(toml), ground);
    for (const Preset& preset : presets()) {
        go_to(session, preset, ground);
        CAPTURE(preset.name);
        CHECK(height_m(session.eye, ground) == doctest::Approx(preset.height_m).epsilon(1e-6));
        CHECK(sun_angles(session).zenith == doctest::Approx(preset.sun_zenith));
        CHECK(std::abs(std::remainder(sun_angles(session).azimuth - session.eye.heading - preset.sun_from_view, 2.0 * pi)) < 1e-9);
    }
}

TEST_CASE("the scroll wheel makes the flight faster and slower, back to what it was, within bounds") {
    Session session = *session_of(scene_of(toml), smooth());
    const double before = session.flown_per_s;
    change_speed(session, 2.0);
    CHECK(session.flown_per_s > before);
    change_speed(session, -2.0);
    CHECK(session.flown_per_s == doctest::Approx(before));
    change_speed(session, 1e6);
    CHECK(session.flown_per_s <= 10.0);
    change_speed(session, -1e6);
    CHECK(session.flown_per_s > 0.0);
}

TEST_CASE("a watch tells once of each file that was written, came or went, also in folders below") {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder.path / "shaders/below");
    REQUIRE(write_file(folder.path / "scene.toml", std::string_view("a")));
    REQUIRE(write_file(folder.path / "shaders/below/a.glsl", std::string_view("a")));
    FileWatch watch({folder.path / "scene.toml", folder.path / "shaders"});
    CHECK(!watch.changed());
    REQUIRE(write_file(folder.path / "scene.toml", std::string_view("abc")));
    CHECK(watch.changed());
    CHECK(!watch.changed());
    // The same length: the time tells.
    REQUIRE(write_file(folder.path / "shaders/below/a.glsl", std::string_view("b")));
    std::filesystem::last_write_time(folder.path / "shaders/below/a.glsl",
                                     std::filesystem::file_time_type::clock::now() + std::chrono::seconds(2));
    CHECK(watch.changed());
    REQUIRE(write_file(folder.path / "shaders/new.glsl", std::string_view("b")));
    CHECK(watch.changed());
    std::filesystem::remove(folder.path / "scene.toml");
    CHECK(watch.changed());
    CHECK(!watch.changed());
}

TEST_CASE("a new picture's name is none that is there") {
    const TemporaryFolder folder;
    CHECK(free_name(folder.path, "airlight", ".png") == folder.path / "airlight-0001.png");
    REQUIRE(write_file(folder.path / "airlight-0001.png", std::string_view("a")));
    REQUIRE(write_file(folder.path / "airlight-0002.png", std::string_view("a")));
    CHECK(free_name(folder.path, "airlight", ".png") == folder.path / "airlight-0003.png");
    CHECK(free_name(folder.path, "airlight", ".exr") == folder.path / "airlight-0001.exr");
}

TEST_CASE("the scene that a session has become begins a session that shows the same") {
    const HeightField ground = smooth();
    Session session = *session_of(scene_of(toml), ground);
    session.eye = {.latitude = -0.3, .longitude = 2.0, .altitude_m = 77.0, .heading = 1.0, .pitch = 0.2};
    session.atmosphere = "mars";
    session.weather = "LOWI 211250Z 07008KT 9999 FEW040 26/12 Q1018";
    session.air.method = AirMethodName::exact;
    place_sun(session, {1.2, 2.5});
    const Session again = *session_of(viewer::scene_of(session), ground);
    CHECK(again.eye == session.eye);
    CHECK(again.atmosphere == session.atmosphere);
    CHECK(again.weather == session.weather);
    CHECK(again.air.method == session.air.method);
    CHECK(again.field_of_view == session.field_of_view);
    CHECK(glm::length(again.towards_sun - session.towards_sun) < 1e-12);
}

TEST_CASE("a probe asks the sky for the direction of a click: straight up, along the horizon, towards the sun") {
    const double bottom_m = 6e6;
    const Viewpoint eye{.latitude = 0.5, .longitude = 0.3, .altitude_m = 1e4, .heading = 2.0};
    const Vec3 from = look(eye, bottom_m).eye, up = direction_of(0.5, 0.3);
    const Vec3 sun = look({.latitude = 0.5, .longitude = 0.3, .heading = 2.7, .pitch = 0.5 * pi - 1.1}, bottom_m).forward;
    const View zenith = view_of({from, up, sun, bottom_m}), ahead = view_of({from, look(eye, bottom_m).forward, sun, bottom_m}),
               sunward = view_of({from, sun, sun, bottom_m});
    CHECK(zenith.altitude.in(m) == doctest::Approx(1e4));
    CHECK(zenith.view_zenith == doctest::Approx(0.0));
    CHECK(zenith.sun_zenith == doctest::Approx(1.1));
    CHECK(ahead.view_zenith == doctest::Approx(0.5 * pi));
    CHECK(ahead.relative_azimuth == doctest::Approx(0.7));
    CHECK(sunward.view_zenith == doctest::Approx(1.1));
    CHECK(sunward.relative_azimuth == doctest::Approx(0.0));
}

TEST_CASE("each edit of a path is in its file at once, is taken back and put back, and goes on when the viewer starts again") {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path / "path.toml";
    Viewpoint eye{.latitude = 0.1, .altitude_m = 100.0};
    {
        PathEdit edit = *PathEdit::open(file);
        CHECK(edit.keys().empty());
        REQUIRE(edit.add({7.0, eye}, 5.0));
        CHECK(read_camera_path(file)->keys == edit.keys());
        eye.altitude_m = 200.0;
        REQUIRE(edit.add({0.0, eye}, 2.0));
        CHECK(edit.keys()[0].time_s == 0.0);
        CHECK(edit.keys()[1].time_s == 2.0);
        REQUIRE(edit.undo());
        CHECK(read_camera_path(file)->keys.size() == 1);
        REQUIRE(edit.redo());
        CHECK(read_camera_path(file)->keys.size() == 2);
        REQUIRE(edit.undo());
        REQUIRE(edit.add({0.0, eye}, 3.0));  // what was taken back is forgotten
        CHECK(!edit.can_redo());
        CHECK(read_camera_path(file)->keys[1].time_s == 3.0);
    }
    PathEdit again = *PathEdit::open(file);
    CHECK(again.keys().size() == 2);
    CHECK(!again.can_undo());
    REQUIRE(again.add({0.0, eye}, 1.0));
    CHECK(read_camera_path(file)->keys.size() == 3);
}

TEST_CASE("a path that cannot be written is told, kept and written when it can be, a file that is no path is left alone") {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path / "later/path.toml";
    PathEdit edit = *PathEdit::open(file);
    const Result<Done> failed = edit.add({}, 1.0);
    REQUIRE(!failed);
    CHECK(failed.error().message().starts_with(file.string()));
    CHECK(edit.unsaved());
    CHECK(edit.keys().size() == 1);
    std::filesystem::create_directories(file.parent_path());
    REQUIRE(edit.save());
    CHECK(!edit.unsaved());
    CHECK(read_camera_path(file)->keys.size() == 1);
    REQUIRE(edit.undo());
    CHECK(!std::filesystem::exists(file));
    REQUIRE(write_file(file, std::string_view("precious = 1\n")));
    CHECK(!PathEdit::open(file));
    CHECK(*read_file(file) == "precious = 1\n");
}

TEST_CASE("keys that cannot be written into the path's file are kept in the refuge, one file for each path, until they can be") {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path / "later/path.toml", refuge = folder.path / "state/airlight";
    PathEdit edit = *PathEdit::open(file, refuge), other = *PathEdit::open(folder.path / "later/other.toml", refuge);
    CHECK(!edit.add({}, 1.0));
    CHECK(!other.add({}, 1.0));
    CHECK(!edit.add({}, 1.0));
    CHECK(edit.kept_in() == refuge / "path-0001.toml");
    CHECK(other.kept_in() == refuge / "path-0002.toml");
    CHECK(read_camera_path(edit.kept_in())->keys == edit.keys());
    std::filesystem::create_directories(file.parent_path());
    REQUIRE(edit.save());
    CHECK(edit.kept_in().empty());
    CHECK(!std::filesystem::exists(refuge / "path-0001.toml"));
    CHECK(read_camera_path(file)->keys == edit.keys());
}

TEST_CASE("what another program writes into a path's file is one more edit, what is no path is not overwritten") {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path / "path.toml", refuge = folder.path / "state";
    PathEdit edit = *PathEdit::open(file, refuge);
    REQUIRE(edit.add({0.0, {.altitude_m = 100.0}}, 1.0));
    REQUIRE(write_file(file, camera_path_text({{{0.0, {.altitude_m = 300.0}}, {2.0, {.altitude_m = 400.0}}}})));
    REQUIRE(edit.follow());
    REQUIRE(edit.keys().size() == 2);
    // A key goes behind what is there, seen or not.
    REQUIRE(write_file(file, camera_path_text({{{0.0, {.altitude_m = 300.0}}, {5.0, {.altitude_m = 400.0}}}})));
    REQUIRE(edit.add({0.0, {.altitude_m = 200.0}}, 1.0));
    CHECK(edit.keys().back().time_s == 6.0);
    CHECK(read_camera_path(file)->keys == edit.keys());
    for (int i = 0; i < 3; ++i) REQUIRE(edit.undo());
    CHECK(edit.keys().size() == 1);
    REQUIRE(write_file(file, std::string_view("[[key]]\ntime_s = \n")));
    CHECK(!edit.follow());
    CHECK(!edit.add({0.0, {.altitude_m = 50.0}}, 1.0));
    CHECK(edit.keys().size() == 2);
    CHECK(*read_file(file) == "[[key]]\ntime_s = \n");
    CHECK(read_camera_path(edit.kept_in())->keys == edit.keys());
    // One that went is written anew.
    std::filesystem::remove(file);
    REQUIRE(edit.save());
    CHECK(read_camera_path(file)->keys == edit.keys());
}

TEST_CASE("a key on the other side of the planet from the last is refused, and the path stays") {
    const TemporaryFolder folder;
    PathEdit edit = *PathEdit::open(folder.path / "path.toml");
    REQUIRE(edit.add({0.0, {.latitude = 0.2}}, 1.0));
    CHECK(!edit.add({0.0, {.latitude = -0.2, .longitude = pi}}, 1.0));
    CHECK(edit.keys().size() == 1);
    CHECK(!edit.unsaved());
}

TEST_CASE("slices cover a picture once, from the highest down, each as long as the slice of a frame may be") {
    for (const auto& [width, height] : {std::pair{333, 100}, {16, 16}, {640, 361}})
        for (const double pixel_ms : {1e-6, 2e-3, 1.0}) {
            Slices slices(width, height);
            CHECK(slices.share() == 0.0);
            std::vector<int> covered(static_cast<std::size_t>(width * height), 0);
            int highest = height, count = 0;
            while (const std::optional<Slices::Slice> slice = slices.next()) {
                REQUIRE(slice->width > 0);
                REQUIRE(slice->height > 0);
                for (int y = slice->bottom; y < slice->bottom + slice->height; ++y)
                    for (int x = slice->left; x < slice->left + slice->width; ++x) ++covered[static_cast<std::size_t>(y * width + x)];
                CHECK(slice->bottom + slice->height <= highest);
                highest = slice->bottom + slice->height;
                const double took_ms = pixel_ms * slice->width * slice->height, tile_ms = pixel_ms * Slices::tile_side * Slices::tile_side;
                CHECK(took_ms <= std::max(Slices::slice_ms, tile_ms) * (1.0 + 1e-9));
                slices.drawn(took_ms);
                ++count;
            }
            CHECK(slices.share() == 1.0);
            CHECK(std::all_of(covered.begin(), covered.end(), [](int times) { return times == 1; }));
            if (pixel_ms < 1e-3) CHECK(count < 16);
        }
}
