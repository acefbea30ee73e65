// Any bytes are a scene or a refusal; what a scene says keeps to the ranges of docs/scene-file.md, and sun and moon stand somewhere.

#include <cmath>

#include "fuzz.h"
#include "scene/scene.h"

using namespace airlight;
using fuzz::demand;

namespace {

bool within(double value, double low, double high) { return value >= low && value <= high; }

void check(const Scene& scene) {
    const Viewpoint& eye = scene.camera.viewpoint;
    demand(within(eye.latitude, -90.0 * deg, 90.0 * deg) && within(eye.longitude, -180.0 * deg, 360.0 * deg), "the camera has a place");
    demand(within(eye.altitude_m, -1e5, 1e9), "the camera is within 1000000 km");
    demand(within(scene.camera.vertical_field_of_view, 1.0 * deg, 150.0 * deg), "a picture has a width");
    demand(within(scene.ground.radius_m, 1e5, 1e8), "a planet has a size");
    demand(within(scene.sun.zenith, 0.0, pi) && within(scene.sun.distance_au, 0.9, 1.1), "the sun stands somewhere");
    demand(std::abs(glm::length(towards_sun(scene)) - 1.0) < 1e-9, "a direction has length one");
    if (const std::optional<Vec3> moon = moon_place(scene)) demand(within(glm::length(*moon), 1e3, 1.02e10), "the moon stands somewhere");
    for (const ObjectScene& object : scene.objects) {
        demand(within(object.foot.altitude_m, -1e5, 1e9) && within(object.foot.pitch, -pi, pi), "an object has a place");
        demand(within(object.size_m.x, 1e-6, 2e8) && within(object.size_m.y, 1e-6, 2e8) && within(object.size_m.z, 1e-6, 2e8),
               "an object has a size");
        demand(within(object.reflectance.x, 0.0, 1.0), "an object reflects a share of light");
    }
    demand(!scene.stars || within(scene.stars->faintest, -2.0, 6.0), "stars have a magnitude");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Result<Scene> scene = parse_scene(fuzz::text_of(data, size), "fuzz.toml");
    if (scene) check(*scene);
    else fuzz::demand_message(scene.error());
    return 0;
}
