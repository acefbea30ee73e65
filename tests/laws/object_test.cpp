// Objects of a scene: what the file says, where they stand, meshes, and what is said of wrong ones.

#include <doctest/doctest.h>

#include <cmath>

#include "scene/scene.h"
#include "terrain/procedural_relief.h"

using namespace airlight;

namespace {

constexpr const char* before = "[camera]\nlatitude = \"46 deg\"\nlongitude = \"8 deg\"\naltitude = \"20 km\"\n[[object]]\n";
constexpr const char* place = "latitude = \"46 deg\"\nlongitude = \"8 deg\"\nabove_ground = \"0 m\"\n";

Result<Scene> scene_with(const std::string& object) { return parse_scene(before + object, "folder/scene.toml"); }

void refuses(const std::string& object, std::string_view words) {
    const Result<Scene> scene = scene_with(object);
    REQUIRE(!scene);
    const std::string message = scene.error().message();
    INFO(message);
    const bool found = message.find(words) != std::string::npos;
    CHECK(found);
}

void refuses_mesh(const std::string& obj, std::string_view words) {
    const Result<Mesh> mesh = parse_mesh(obj, "a.obj");
    REQUIRE(!mesh);
    const std::string message = mesh.error().message();
    INFO(message);
    const bool found = message.find("a.obj: ") == 0 && message.find(words) != std::string::npos;
    CHECK(found);
}

}  // namespace

TEST_CASE("a scene says what its objects are, and leaves the rest at what the document says") {
    const std::string sphere = std::string("shape = \"sphere\"\nradius = \"500 km\"\n") + place;
    const std::string mesh =
        std::string("[[object]]\nshape = \"mesh\"\nfile = \"a.obj\"\nunit = \"0.01 m\"\nreflectance = [0.1, 0.2, 1]\n") + place;
    const Result<Scene> scene = scene_with(sphere + mesh);
    if (!scene) FAIL(scene.error().message());
    REQUIRE(scene->objects.size() == 2);
    CHECK(scene->objects[0].shape == Shape::sphere);
    CHECK(scene->objects[0].size_m == Vec3(1e6));
    CHECK(scene->objects[0].reflectance == Vec3(0.5));
    CHECK(scene->objects[0].above_ground);
    CHECK(scene->objects[1].mesh == std::filesystem::path("folder/a.obj"));
    CHECK(scene->objects[1].size_m.x == doctest::Approx(0.01));
    CHECK(scene->objects[1].reflectance == Vec3(0.1, 0.2, 1.0));
}

TEST_CASE("a wrong object is one message with file, line, key, value, the rule and what to do") {
    refuses(place, "scene.toml:5: object.shape is missing");
    refuses(std::string("shape = \"cube\"\n") + place,
            "scene.toml:6: object.shape = \"cube\": it must be one of: sphere box cylinder mesh");
    refuses(std::string("shape = \"sphere\"\n") + place, "object.radius is missing");
    refuses(std::string("shape = \"sphere\"\nradius = \"0 m\"\n") + place, "object.radius = \"0 m\": it must be from 1 mm to 100000 km");
    refuses(std::string("shape = \"sphere\"\nradius = \"-1 m\"\n") + place, "it must be from 1 mm to 100000 km");
    refuses(std::string("shape = \"sphere\"\nradius = 3\n") + place, "a number and a unit in quotes");
    refuses(std::string("shape = \"sphere\"\nradius = \"1 m\"\nheight = \"1 m\"\n") + place, "object.height is no key");
    refuses(std::string("shape = \"box\"\nwidth = \"1 m\"\nlength = \"1 m\"\n") + place, "object.height is missing");
    refuses("shape = \"sphere\"\nradius = \"1 m\"\nlatitude = \"6 deg\"\naltitude = \"1 m\"\n", "object.longitude is missing");
    refuses("shape = \"sphere\"\nradius = \"1 m\"\nlatitude = \"6 deg\"\nlongitude = \"8 deg\"\n", "object.altitude is missing");
    refuses(std::string("shape = \"mesh\"\n") + place, "object.file is missing");
    for (const char* wrong : {"[0.1, 0.2]", "[0.1, 0.2, 1.5]", "[-0.1, 0.2, 0.3]"})
        refuses(std::string("shape = \"sphere\"\nradius = \"1 m\"\nreflectance = ") + wrong + '\n' + place, "three numbers from 0 to 1");
    refuses(std::string("shape = \"sphere\"\nradius = \"1 m\"\ntilt = \"200 deg\"\n") + place, "from -180 deg to 180 deg");
}

TEST_CASE("an object stands on its foot: on the ground there, upright but for its tilt, which leans it towards its heading") {
    const std::string box =
        std::string("shape = \"box\"\nwidth = \"1 m\"\nlength = \"2 m\"\nheight = \"6 m\"\nheading = \"90 deg\"\n") + place;
    const Result<Scene> upright = scene_with(box), leaning = scene_with("tilt = \"30 deg\"\n" + box);
    REQUIRE(upright);
    REQUIRE(leaning);
    const HeightField ground = *ground_of(*upright);
    const Vec3 up = direction_of(46.0 * deg, 8.0 * deg), east = glm::normalize(glm::cross(Vec3(0, 0, 1), up));
    const Vec3 foot = (ground.radius_m + surface_m(upright->objects[0].foot, ground)) * up;
    const Object stands = objects_of(*upright, ground)->front(), leans = objects_of(*leaning, ground)->front();
    CHECK(stands.half_size_m == Vec3(0.5, 1.0, 3.0));
    CHECK(glm::length(stands.centre - foot - 3.0 * up) < 1e-6);
    CHECK(glm::length(stands.forward - east) < 1e-9);
    CHECK(glm::length(leans.centre - foot - 3.0 * (std::cos(30.0 * deg) * up + std::sin(30.0 * deg) * east)) < 1e-6);
    CHECK(reach_m(stands) == doctest::Approx(std::sqrt(10.25)));
}

TEST_CASE("a mesh is the triangles of its faces, with the file's normals or their own") {
    const Result<Mesh> mesh =
        parse_mesh("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nvn 0 3 4\nf 1 2 3 4\nf 1//1 2//1 3//1\nf -4 -3 -3\n", "a.obj");
    if (!mesh) FAIL(mesh.error().message());
    CHECK(mesh->corners.size() == 9);  // the last face has no area
    CHECK(mesh->corners[0].normal == std::array{0.0f, 0.0f, 1.0f});
    CHECK(mesh->corners[6].normal == std::array{0.0f, 0.6f, 0.8f});
    CHECK(mesh->reach == doctest::Approx(std::sqrt(5.0)));
}

TEST_CASE("a wrong mesh is one message") {
    refuses_mesh("", "it has no triangles");
    refuses_mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\n", "it has no triangles");
    refuses_mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 1\n", "it has no triangles");
    refuses_mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "a face names a corner that is not there");
    refuses_mesh("v 0 0 0\nv 1e20 0 0\nv 0 1 0\nf 1 2 3\n", "a corner is no number below 10^9");
    refuses_mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 2 3\n", "it is no mesh");
    const Result<Mesh> absent = read_mesh("absent.obj");
    REQUIRE(!absent);
    CHECK(absent.error().message().find("absent.obj: cannot be read") == 0);
}
