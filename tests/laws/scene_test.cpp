// The scene file: what it says, and what is said of a wrong one.

#include <doctest/doctest.h>

#include <cmath>

#include "scene/scene.h"

using namespace airlight;

namespace {

constexpr const char* camera = "[camera]\nlatitude = \"46 deg\"\nlongitude = \"8 deg\"\naltitude = \"20 km\"\n";

std::string error_of(const std::string& toml) {
    const Result<Scene> scene = parse_scene(toml, "folder/scene.toml");
    REQUIRE(!scene);
    return scene.error().message();
}

bool says(const std::string& message, std::string_view words) {
    INFO(message);
    const bool found = message.find(words) != std::string::npos;
    CHECK(found);
    return found;
}

}  // namespace

TEST_CASE("a scene says its ground, camera and sun, and leaves the rest at what the document says") {
    const Result<Scene> scene = parse_scene(std::string(camera) +
                                                "heading = \"120 deg\"\npitch = \"-5 deg\"\n"
                                                "[ground]\nelevation = \"heights.tif\"\nsea = false\nradius = \"3390 km\"\n[sun]\nzenith = "
                                                "\"80 deg\"\n[air]\nmethod = \"exact\"\nshafts = \"planes\"\n",
                                            "folder/scene.toml");
    if (!scene) FAIL(scene.error().message());
    CHECK(scene->camera.viewpoint.latitude == doctest::Approx(46.0 * deg));
    CHECK(scene->camera.viewpoint.altitude_m == 20e3);
    CHECK(scene->camera.viewpoint.pitch == doctest::Approx(-5.0 * deg));
    CHECK(scene->camera.vertical_field_of_view == doctest::Approx(60.0 * deg));
    CHECK(scene->ground.elevation == std::filesystem::path("folder/heights.tif"));
    CHECK(!scene->ground.sea);
    CHECK(scene->ground.radius_m == 3.39e6);
    CHECK(scene->air.method == AirMethodName::exact);
    CHECK(scene->air.shafts == ShaftsName::planes);
    CHECK(parse_scene(camera, "scene.toml")->air.method == AirMethodName::airlight);
    CHECK(parse_scene(camera, "scene.toml")->weather.empty());
    CHECK(parse_scene(std::string("weather = \"report.txt\"\n") + camera, "scene.toml")->weather == "report.txt");
    CHECK(scene->sun.zenith == doctest::Approx(80.0 * deg));
    CHECK(scene->sun.azimuth == doctest::Approx(180.0 * deg));
}

TEST_CASE("a wrong scene is one message with file, line, key, value, the rule and what to do") {
    const std::string misspelt = error_of(std::string(camera) + "headng = \"120 deg\"\n");
    says(misspelt, "folder/scene.toml:5");
    says(misspelt, "camera.headng");
    says(misspelt, "Did you mean \"heading\"?");
    // One that must be there is not only missing.
    const std::string needed = error_of("[camera]\nlattitude = \"46 deg\"\nlongitude = \"8 deg\"\naltitude = \"20 km\"\n");
    says(needed, "folder/scene.toml:2: camera.lattitude is no key");
    says(needed, "Did you mean \"latitude\"?");
    says(error_of("[camra]\nlatitude = \"46 deg\"\n"), "scene.toml:1: camra is no key");
    says(error_of("[camera]\nlongitude = \"8 deg\"\naltitude = \"20 km\"\nroll = \"2 deg\"\n"), "camera.latitude is missing");
    says(error_of("[camera]\nlatitude = \"96 deg\"\nlongitude = \"8 deg\"\naltitude = \"1 km\"\n"),
         "scene.toml:2: camera.latitude = \"96 deg\": it must be from -90 deg to 90 deg");
    says(error_of("[camera]\nlatitude = \"6 deg\"\naltitude = \"1 km\"\n"), "camera.longitude is missing");
    says(error_of("[camera]\nlatitude = \"6 deg\"\nlongitude = \"8 deg\"\n"), "above_ground = \"2 m\"");
    says(error_of(std::string(camera) + "above_ground = \"2 m\"\n"), "Keep one of them");
    says(error_of(std::string(camera) + "pitch = 5\n"), "a number and a unit in quotes");
    says(error_of(std::string(camera) + "[sun]\ntime = \"yesterday\"\n"), "sun.time = \"yesterday\"");
    says(error_of(std::string(camera) + "[sun]\ntime = \"2024-06-21T12:00Z\"\nzenith = \"3 deg\"\n"), "time is given as well");
    says(error_of(std::string(camera) + "[stars]\nfaintest = 4\n"), "stars.time is missing");
    says(error_of(std::string(camera) + "[stars]\ntime = \"2024-06-21T12:00Z\"\nfaintest = 9\n"), "a magnitude from -2 to 6");
    says(error_of(std::string(camera) + "[moon]\nphase = \"3 deg\"\n"), "moon.phase is no key");
    says(error_of(std::string(camera) + "[ground]\nsea = \"yes\"\n"), "it must be true or false");
    says(error_of(std::string(camera) + "[ground]\nseed = 1.5\n"), "a whole number");
    says(error_of(std::string(camera) + "[air]\nmethod = \"exakt\"\n"),
         "air.method = \"exakt\": it must be one of: airlight hillaire2020 bruneton2008 exact");
    says(error_of(std::string(camera) + "[air]\nshafts = \"planets\"\n"), "air.shafts = \"planets\": it must be one of: epipolar");
    says(error_of(std::string(camera) + "[planet]\n"), "planet is no key");
    says(error_of(""), "camera is missing");
    says(error_of("[camera\n"), "scene.toml:1: it is not TOML");
    says(error_of("[camera\n"), "docs/scene-file.md");
    CHECK(!read_scene("/no/such/scene.toml"));
}

TEST_CASE("a scene's camera stands above its ground, and is not put into it") {
    Scene scene = *parse_scene(camera, "scene.toml");
    const HeightField ground = *ground_of(scene);
    const Vec3 zenith = direction_of(46.0 * deg, 8.0 * deg);
    CHECK(glm::length(camera_of(scene, ground, 64, 36)->eye) == doctest::Approx(ground.radius_m + 20e3).epsilon(1e-15));
    scene.camera.above_ground = true;
    scene.camera.viewpoint.altitude_m = 2.0;
    const double surface = std::max(0.0, ground.sample(zenith, 1.0).height_m);
    CHECK(glm::length(camera_of(scene, ground, 64, 36)->eye) == doctest::Approx(ground.radius_m + surface + 2.0).epsilon(1e-15));
    scene.camera.above_ground = false;
    scene.camera.viewpoint.altitude_m = surface - 10.0;
    const Result<Camera> buried = camera_of(scene, ground, 64, 36);
    REQUIRE(!buried);
    says(buried.error().message(), "is in the ground");
}

TEST_CASE("the sun of a time stands where it does over the camera's place") {
    // Noon at Greenwich on the day of the equinox, from the equator: within the equation of time, 7.4 minutes, of the zenith.
    const Scene scene = *parse_scene(
        "[camera]\nlatitude = \"0 deg\"\nlongitude = \"0 deg\"\naltitude = \"20 km\"\n[sun]\ntime = \"2024-03-20T12:00:00Z\"\n", "s.toml");
    CHECK(std::acos(glm::dot(towards_sun(scene), direction_of(0.0, 0.0))) < 2.5 * deg);
    // A sun in the east at the horizon.
    const Scene east = *parse_scene(
        "[camera]\nlatitude = \"0 deg\"\nlongitude = \"0 deg\"\naltitude = \"20 km\"\n[sun]\nzenith = \"90 deg\"\nazimuth = \"90 deg\"\n",
        "s.toml");
    CHECK(glm::length(towards_sun(east) - Vec3(0.0, 1.0, 0.0)) < 1e-12);
}

TEST_CASE("a scene's elevation file that is missing is one message with its path") {
    const Scene scene = *parse_scene(std::string(camera) + "[ground]\nelevation = \"none.tif\"\n", "folder/scene.toml");
    const Result<HeightField> ground = ground_of(scene);
    REQUIRE(!ground);
    says(ground.error().message(), "folder/none.tif: there is no such file");
}

TEST_CASE("a time places moon and stars as well, without one the moon stands where the scene says, and there are no stars") {
    const std::string time = "[sun]\ntime = \"2024-04-08T18:17:20Z\"\n", over_mexico =
                                                                             "[camera]\nlatitude = \"25.3 deg\"\nlongitude = "
                                                                             "\"-104.1 deg\"\naltitude = \"20 km\"\n";
    const Scene eclipse = *parse_scene(over_mexico + time, "s.toml");
    REQUIRE(moon_place(eclipse));
    const Vec3 ground = eclipse.ground.radius_m * direction_of(25.3 * deg, -104.1 * deg);
    // The greatest eclipse was there and then: the centres of both were half a minute of arc apart.
    CHECK(glm::length(glm::normalize(*moon_place(eclipse) - ground) - towards_sun(eclipse)) < 0.02 * deg);
    CHECK(stars_of(eclipse).size() > 5000);
    CHECK(eclipse.sun.time == *parse_utc("2024-04-08T18:17:20Z"));
    CHECK(stars_of(*parse_scene(over_mexico + time + "[stars]\nfaintest = 1.5\n", "s.toml")).size() == 23);
    CHECK(!moon_place(*parse_scene(over_mexico + time + "[moon]\nvisible = false\n", "s.toml")));
    CHECK(stars_of(*parse_scene(over_mexico + time + "[stars]\nvisible = false\n", "s.toml")).empty());
    const Scene plain = *parse_scene(over_mexico, "s.toml");
    CHECK(!moon_place(plain));
    CHECK(stars_of(plain).empty());
    const Scene placed = *parse_scene(over_mexico + "[moon]\nzenith = \"0 deg\"\ndistance = \"400000 km\"\n", "s.toml");
    CHECK(glm::length(*moon_place(placed)) == doctest::Approx(plain.ground.radius_m + 4e8));
}
