// The way of a camera: its file, and what lies between its keys.

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "scene/camera_path.h"
#include "terrain/cube_sphere.h"

using namespace airlight;

namespace {

constexpr const char* one_key = "[[key]]\ntime_s = 0\nlatitude = \"46 deg\"\nlongitude = \"8 deg\"\naltitude = \"20 km\"\n";

std::string error_of(const std::string& toml) {
    const Result<CameraPath> path = parse_camera_path(toml, "path.toml");
    REQUIRE(!path);
    return path.error().message();
}

void says(const std::string& message, std::string_view words) {
    INFO(message);
    CHECK(message.find(words) != std::string::npos);
}

CameraPath descent() {
    return {{{0.0, {.latitude = 0.7, .longitude = 3.0, .altitude_m = 2e7, .heading = 6.0, .pitch = -1.5}},
             {4.0, {.latitude = 0.75, .longitude = -3.1, .altitude_m = 4e5, .heading = 0.2, .pitch = -0.3}},
             {5.0, {.latitude = 0.76, .longitude = -3.0, .altitude_m = 3e3, .heading = 1.0, .pitch = -0.1}, 40.0 * deg},
             {9.0, {.latitude = 0.76, .longitude = -3.0, .altitude_m = 1.7, .heading = -2.5, .pitch = 0.1}}}};
}

double apart(const CameraKey& a, const CameraKey& b) {
    return angle_between(direction_of(a.eye.latitude, a.eye.longitude), direction_of(b.eye.latitude, b.eye.longitude));
}

}  // namespace

TEST_CASE("a path reads back from its text as it was") {
    const Result<CameraPath> read = parse_camera_path(camera_path_text(descent()), "path.toml");
    if (!read) FAIL(read.error().message());
    CHECK(*read == descent());
}

TEST_CASE("what a key leaves out is level, north and 60 degrees wide") {
    const CameraPath path = *parse_camera_path(one_key, "path.toml");
    CHECK(path.keys.size() == 1);
    CHECK(path.keys[0].eye.heading == 0.0);
    CHECK(path.keys[0].eye.pitch == 0.0);
    CHECK(path.keys[0].vertical_field_of_view == 60.0 * deg);
}

TEST_CASE("a wrong path is one message with file, line, key, value, the rule and what to do") {
    says(error_of(std::string(one_key) + "headng = \"1 deg\"\n"), "path.toml:6: key.headng is no key");
    says(error_of(std::string(one_key) + "headng = \"1 deg\"\n"), "Did you mean \"heading\"?");
    says(error_of(std::string(one_key) + one_key), "path.toml:7: key.time_s = 0: it must be after the key before");
    says(error_of("[[key]]\ntime_s = 0\nlatitude = \"95 deg\"\nlongitude = \"8 deg\"\naltitude = \"20 km\"\n"), "from -90 deg to 90 deg");
    says(error_of("[[key]]\ntime_s = 0\nlatitude = \"5 deg\"\nlongitude = \"8 deg\"\n"), "key.altitude is missing");
    says(error_of(std::string(one_key) + "[[key]]\ntime_s = 1\nlatitude = \"-46 deg\"\nlongitude = \"188 deg\"\naltitude = \"20 km\"\n"),
         "Put a key between them");
    says(error_of(""), "key is missing");
    says(error_of("[[key]\n"), "docs/camera-path.md");
    CHECK(!read_camera_path("/no/such/path.toml"));
}

TEST_CASE("the camera passes its keys, and stands still before the first and after the last") {
    const CameraPath path = descent();
    for (const CameraKey& key : path.keys) {
        const CameraKey there = camera_at(path, key.time_s);
        CHECK(apart(there, key) < 1e-12);
        CHECK(there.eye.altitude_m == doctest::Approx(key.eye.altitude_m).epsilon(1e-12));
        CHECK(std::abs(std::remainder(there.eye.heading - key.eye.heading, 2.0 * pi)) < 1e-12);
        CHECK(there.eye.pitch == doctest::Approx(key.eye.pitch).epsilon(1e-12));
        CHECK(there.vertical_field_of_view == doctest::Approx(key.vertical_field_of_view).epsilon(1e-12));
    }
    CHECK(camera_at(path, -5.0).eye == path.keys.front().eye);
    CHECK(camera_at(path, 50.0).eye == path.keys.back().eye);
}

TEST_CASE("between two keys the camera goes beyond neither, and its heading takes the shorter way") {
    const CameraPath path = descent();
    for (std::size_t i = 0; i + 1 < path.keys.size(); ++i) {
        const CameraKey &a = path.keys[i], &b = path.keys[i + 1];
        const double turn = std::abs(std::remainder(b.eye.heading - a.eye.heading, 2.0 * pi));
        for (double t = a.time_s; t < b.time_s; t += 0.01) {
            const CameraKey there = camera_at(path, t);
            CHECK(there.eye.altitude_m <= a.eye.altitude_m * (1.0 + 1e-12));
            CHECK(there.eye.altitude_m >= b.eye.altitude_m * (1.0 - 1e-12));
            CHECK(there.eye.pitch >= a.eye.pitch - 1e-12);
            CHECK(there.eye.pitch <= b.eye.pitch + 1e-12);
            CHECK(std::abs(std::remainder(there.eye.heading - a.eye.heading, 2.0 * pi)) <= turn + 1e-12);
            CHECK(apart(there, a) + apart(there, b) <= apart(a, b) + 0.01);
        }
    }
}

// Halving the step halves a jump of the place, but quarters the change of a speed that does not jump.
TEST_CASE("neither place nor speed jumps, at keys as well") {
    const CameraPath path = descent();
    const auto height = [&](double t) { return std::asinh(camera_at(path, t).eye.altitude_m / 10.0); };
    for (const CameraKey& key : path.keys) {
        const auto kink = [&](double h) { return std::abs(height(key.time_s + h) - 2.0 * height(key.time_s) + height(key.time_s - h)); };
        CHECK(kink(1e-3) < 0.3 * kink(2e-3) + 1e-12);
        CHECK(kink(1e-3) < 1e-4);
    }
}

TEST_CASE("a key may count from the ground or the sea, and its path reads back so, over a ground it counts from 0 m") {
    const std::string walk = "[[key]]\ntime_s = 0\nlatitude = \"46 deg\"\nlongitude = \"8 deg\"\nabove_ground = \"2 m\"\n";
    const CameraPath path = *parse_camera_path(walk, "path.toml");
    CHECK(path.keys[0].above_ground);
    CHECK(*parse_camera_path(camera_path_text(path), "path.toml") == path);
    HeightField ground{.radius_m = 6.371e6,
                       .sample =
                           [](Vec3, double) {
                               return HeightSample{1500.0, {}, {}, {}};
                           },
                       .range = {},
                       .detail = {},
                       .whole = {},
                       .sea = true};
    CHECK(over(ground, path).keys[0].eye.altitude_m == 1502.0);
    CHECK(!over(ground, path).keys[0].above_ground);
    ground.sample = [](Vec3, double) { return HeightSample{-300.0, {}, {}, {}}; };
    CHECK(over(ground, path).keys[0].eye.altitude_m == 2.0);
    CHECK(over(ground, descent()) == descent());
    says(error_of(walk + "altitude = \"2 km\"\n"), "key.altitude = \"2 km\": above_ground is given as well");
    says(error_of("[[key]]\ntime_s = 0\nlatitude = \"4 deg\"\nlongitude = \"8 deg\"\nabove_ground = \"0 m\"\n"),
         "it must be from 0.2 m to 1000000 km");
}

TEST_CASE("keys may say when the sun stands so: the time passes theirs, and never runs back between two of them") {
    CameraPath path = descent();
    const char* times[] = {"2024-06-21T10:00:00Z", "2024-06-21T12:00:00Z", "2024-06-21T19:30:15.25Z", "2024-06-22T04:00:00Z"};
    for (std::size_t i = 0; i < path.keys.size(); ++i) path.keys[i].sky_time = *parse_utc(times[i]);
    CHECK(*parse_camera_path(camera_path_text(path), "path.toml") == path);
    for (const CameraKey& key : path.keys) CHECK(std::abs(seconds_between(*key.sky_time, *camera_at(path, key.time_s).sky_time)) < 1e-6);
    CHECK(camera_at(path, -1.0).sky_time == path.keys.front().sky_time);
    CHECK(camera_at(path, 99.0).sky_time == path.keys.back().sky_time);
    for (double t = path.begin_s(); t < path.end_s(); t += 0.01)
        CHECK(seconds_between(*camera_at(path, t).sky_time, *camera_at(path, t + 0.01).sky_time) >= 0.0);
    CHECK(!camera_at(descent(), 2.0).sky_time);
    const std::string timed = std::string(one_key) + "time = \"2024-06-21T10:00Z\"\n";
    const std::string later = "[[key]]\ntime_s = 1\nlatitude = \"46 deg\"\nlongitude = \"8 deg\"\naltitude = \"20 km\"\n";
    says(error_of(timed + later), "path.toml:7: key.time is missing");
    says(error_of(one_key + later + "time = \"2024-06-21T10:00Z\"\n"), "the keys before have none");
    says(error_of(std::string(one_key) + "time = \"noon\"\n"), "path.toml:6: key.time = \"noon\"");
}

TEST_CASE("a way past a pole is as even as any other") {
    const CameraPath path = {
        {{0.0, {.latitude = 89.0 * deg, .longitude = 0.0}}, {1.0, {.latitude = 89.0 * deg, .longitude = 180.0 * deg}}}};
    CHECK(camera_at(path, 0.5).eye.latitude == doctest::Approx(90.0 * deg));
    for (double t = 0.0; t < 1.0; t += 0.01) CHECK(apart(camera_at(path, t), camera_at(path, t + 0.01)) < 0.05 * deg);
}
