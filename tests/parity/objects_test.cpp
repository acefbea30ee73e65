// Free objects in the geometry buffer against where a pixel's ray meets them, in double; and the air before one that is half in it.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "atmosphere/presets.h"
#include "models/airlight_tables.h"
#include "models/model.h"
#include "render/air_exact.h"
#include "render/air_pass.h"
#include "render/camera_block.h"
#include "render/geometry_buffer.h"
#include "render/object_pass.h"
#include "terrain/octahedral.h"
#include "tools/gpu_case.h"
#include "tools/object_rays.h"
#include "tools/skylight.h"
#include "tools/temporary_folder.h"

using namespace airlight;
using namespace airlight::test;

namespace {

constexpr int side = 64;

// Where a ray of length one from `eye` enters an object from outside.
struct Hit {
    double distance_m;
    Vec3 normal;
};
std::optional<Hit> hit(const Object& o, Vec3 eye, Vec3 direction) {
    const std::optional<RayInObject> way = ray_in(o, eye, direction);
    if (!way || way->enters_m <= 0.0) return {};
    return Hit{way->enters_m, way->normal};
}

// An object of a size, turned about, whose centre stands at a place.
Object turned(Shape shape, Vec3 centre, Vec3 half_size_m) {
    const Camera axes = look(centre, Vec3(0.3, 0.8, -0.2), Vec3(0.1, 0.2, 1.0));
    return {shape, centre, axes.right, axes.forward, axes.up, half_size_m, Vec3(0.5)};
}

Vec3 pixel_direction(const Camera& camera, std::size_t at) {
    return direction_at(camera, (static_cast<double>(at % side) + 0.5) / side * 2.0 - 1.0,
                        (static_cast<double>(at / side) + 0.5) / side * 2.0 - 1.0);
}

// How far a picture of an object is from the truth, the depth as a share of the distance.
struct Errors {
    double depth = 0.0, normal = 0.0;
    std::size_t hits = 0, elsewhere = 0;  // pixels that it covers, and that only one of both says it covers
};

Errors errors_of(const Object& object, const Camera& camera) {
    const render::GeometryBuffer surfaces = must(render::GeometryBuffer::create(side, side));
    const render::CameraBlock block;
    block.bind(camera);
    surfaces.begin();
    must(render::ObjectPass::create(std::span(&object, 1))).draw();
    render::GeometryBuffer::end();
    std::vector<float> depth(side * side), normal(2 * side * side);
    surfaces.depth().read(depth);
    surfaces.normal().read(normal);
    Errors errors;
    for (std::size_t at = 0; at < depth.size(); ++at) {
        const Vec3 direction = pixel_direction(camera, at);
        const std::optional<Hit> truth = hit(object, camera.eye, direction);
        errors.hits += truth.has_value();
        if (truth.has_value() != (depth[at] > 0.0f)) ++errors.elsewhere;
        if (!truth || depth[at] == 0.0f) continue;
        // Where the surface is seen at a low angle a direction's rounding takes its place along.
        const double facing = -glm::dot(direction, truth->normal);
        const double distance = render::near_m / static_cast<double>(depth[at]) / glm::dot(direction, camera.forward);
        errors.depth = std::max(errors.depth, facing * std::abs(distance / truth->distance_m - 1.0));
        const auto level = [](float x) { return static_cast<std::uint32_t>(std::lround(x * 65535.0f)); };
        const Vec3 seen = from_octahedral(level(normal[2 * at]) | level(normal[2 * at + 1]) << 16);
        errors.normal = std::max(errors.normal, facing * glm::length(glm::cross(seen, truth->normal)));
    }
    return errors;
}

void check(const Errors& errors, std::size_t fewest_hits) {
    CHECK(errors.hits > fewest_hits);
    CHECK(errors.elsewhere == 0);
    CHECK(errors.depth <= 1e-6);
    CHECK(errors.normal <= 1e-4);
}

Camera camera_towards(Vec3 eye, Vec3 place) {
    Camera camera = look(eye, place - eye, Vec3(0.0, 0.0, 1.0));
    camera.width = camera.height = side;
    return camera;
}

}  // namespace

// Float leaves 2^-24 in each of: the direction, the eye's way to the centre or to the face, the depth. The normal's rounding in the buffer
// is 6e-5.
TEST_CASE("an object's depth is right to a millionth of its distance, and its normal to the buffer's rounding, from 1 m to 40 000 km") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const Vec3 eye = 6.38e6 * glm::normalize(Vec3(0.4, -0.7, 0.6)), towards = glm::normalize(Vec3(0.5, 0.6, -0.1));
    fmt::print("  {:>12} {:>12}  error of depth, of normal (rad)\n", "distance, m", "size, m");
    for (const Shape shape : {Shape::sphere, Shape::box, Shape::cylinder})
        for (const double distance_m : {1.0, 100.0, 1e4, 1e6, 4e7})
            for (const double size : {0.1, 0.6, 0.95}) {
                const Vec3 half_size =
                    size / std::sqrt(3.0) * distance_m * Vec3(1.0, shape == Shape::box ? 0.5 : 1.0, shape == Shape::sphere ? 1.0 : 0.7);
                const Object object = turned(shape, eye + distance_m * towards, half_size);
                const Errors errors = errors_of(object, camera_towards(eye, object.centre));
                fmt::print("  {:>12.0f} {:>12.4g}  {:.1e} {:.1e}\n", distance_m, half_size.x, errors.depth, errors.normal);
                check(errors, 20);
            }
}

TEST_CASE("an eye that stands 1 m from a moon, or from a wall of 1000 km, sees it where it is") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const Vec3 eye = 6.38e6 * glm::normalize(Vec3(0.4, -0.7, 0.6));
    for (const Shape shape : {Shape::sphere, Shape::box, Shape::cylinder})
        for (const double half_m : {10.0, 5e5}) {
            Object object = turned(shape, eye, Vec3(half_m));
            object.centre = eye - (half_m + 1.0) * object.right;
            // Along the surface, so that half of the picture is sky, and down to it.
            for (const Vec3 way : {object.forward - 0.1 * object.right, 0.2 * object.up - object.right}) {
                const Errors errors = errors_of(object, camera_towards(eye, eye + way));
                fmt::print("  half of {:>8.0f} m: {:.1e} {:.1e}\n", half_m, errors.depth, errors.normal);
                check(errors, 500);
            }
        }
}

// Two sides of a square that meet at a right angle, the second wound the other way: both are seen from inside of the angle.
TEST_CASE("a mesh shows each triangle with the normal of the side that is seen") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    Object object = turned(Shape::mesh, 6.38e6 * glm::normalize(Vec3(0.4, -0.7, 0.6)), Vec3(0.5));
    object.mesh = std::make_shared<const Mesh>(
        must(parse_mesh("v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv -1 -2 -1\nv 1 -2 -1\nf 1 2 3 4\nf 1 2 6 5\n", "angle.obj")));
    const Camera camera = camera_towards(object.centre - 3.0 * object.forward + 2.0 * object.up, object.centre - 0.2 * object.forward);
    const render::GeometryBuffer surfaces = must(render::GeometryBuffer::create(side, side));
    const render::CameraBlock block;
    block.bind(camera);
    surfaces.begin();
    must(render::ObjectPass::create(std::span(&object, 1))).draw();
    render::GeometryBuffer::end();
    std::vector<float> depth(side * side), normal(2 * side * side);
    surfaces.depth().read(depth);
    surfaces.normal().read(normal);
    std::array<std::size_t, 2> seen_sides{};
    for (std::size_t at = 0; at < depth.size(); ++at) {
        if (depth[at] == 0.0f) continue;
        const Vec3 direction = pixel_direction(camera, at);
        const Vec3 p = along_axes(
            object,
            camera.eye + render::near_m / static_cast<double>(depth[at]) / glm::dot(direction, camera.forward) * direction - object.centre);
        const bool upright = p.z > -0.499;
        ++seen_sides[upright];
        const auto level = [](float x) { return static_cast<std::uint32_t>(std::lround(x * 65535.0f)); };
        const Vec3 seen = from_octahedral(level(normal[2 * at]) | level(normal[2 * at + 1]) << 16);
        CHECK(glm::length(seen - (upright ? -object.forward : object.up)) < 1e-4);
        CHECK(std::abs(upright ? p.y : p.z + 0.5) < 1e-5);
    }
    CHECK(seen_sides[0] > 50);
    CHECK(seen_sides[1] > 50);
}

// [Sperlhofer2011, section 4.7.5]: a sphere of 80 km half in the air, seen from within and from without. The pass takes eight nodes a piece of
// a ray for the CPU's twelve: 3 %.
TEST_CASE("of an object half in the air each pixel has the light of the air before it, as on the CPU, and what it reflects through it") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const Atmosphere atmosphere = *preset("earth-clear");
    const std::vector<Wavelength> wavelengths = {450.0 * nm, 550.0 * nm, 650.0 * nm};
    const std::vector<Vec3> colours = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
    const BakeSettings quick = {
        .sizes = {.transmittance_mu = 64, .transmittance_altitude = 32, .sun = 24, .azimuth = 4, .view = 8, .altitude = 12}, .orders = 2};
    const TemporaryFolder cache;
    const Tables tables = must(cached_tables(atmosphere, wavelengths, quick, {.folder = cache.path}, {}));
    const AirlightTables packed = airlight_tables(tables.packs()[0], 12);
    const std::unique_ptr<Sky> sky = *make_sky("airlight", atmosphere, wavelengths, {.bake = quick, .cache = {.folder = cache.path}});
    render::AirPass air = must(render::AirPass::create({atmosphere, wavelengths, colours}, render::exact_air(tables, colours)));
    const double bottom_m = atmosphere.bottom_radius.in(m), top_m = atmosphere.top_altitude.in(m), radius_m = 8e4;
    const gpu::Texture radiance({side, side});
    const render::GeometryBuffer surfaces = must(render::GeometryBuffer::create(side, side));
    const gpu::Framebuffer target = must(gpu::Framebuffer::create({&radiance}, &surfaces.depth()));
    const auto angle = [](Vec3 a, Vec3 b) { return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)); };
    fmt::print("  eye, m     altitude of what is seen, m    light of the CPU, of the GPU\n");
    for (const double eye_m : {2e3, 4e5})
        for (const double reflectance : {0.0, 0.8}) {
            const Camera level = look(Viewpoint{.latitude = 0.7, .longitude = 0.2, .altitude_m = eye_m, .heading = 0.5}, bottom_m);
            Object object = turned(Shape::sphere, {}, Vec3(radius_m));
            object.centre = (bottom_m + top_m) * glm::normalize(level.eye + 6e5 * level.forward);
            object.reflectance = Vec3(reflectance);
            const Camera camera = camera_towards(level.eye, object.centre);
            const Vec3 sun = glm::normalize(level.up + level.right - 0.5 * level.forward);
            const render::CameraBlock block;
            block.bind(camera);
            gpu::PassTimers timers;
            air.prepare(camera, sun, timers, {});
            surfaces.begin();
            must(render::ObjectPass::create(std::span(&object, 1))).draw();
            render::GeometryBuffer::end();
            target.bind();
            REQUIRE(air.draw(surfaces));
            std::vector<float> pixels(4 * side * side);
            radiance.read(pixels);
            // The highest and the lowest of its pixels, of those that are well within it.
            std::array<std::size_t, 2> chosen{};
            std::array<double, 2> altitudes = {1e300, -1e300};
            for (std::size_t at = 0; at < side * side; ++at) {
                const std::optional<Hit> truth = hit(object, camera.eye, pixel_direction(camera, at));
                if (!truth || -glm::dot(truth->normal, pixel_direction(camera, at)) < 0.5) continue;
                const double altitude = glm::length(camera.eye + truth->distance_m * pixel_direction(camera, at)) - bottom_m;
                if (altitude < altitudes[0]) altitudes[0] = altitude, chosen[0] = at;
                if (altitude > altitudes[1]) altitudes[1] = altitude, chosen[1] = at;
            }
            REQUIRE(altitudes[0] < 0.8 * top_m);
            REQUIRE(altitudes[1] > 1.2 * top_m);
            for (const std::size_t at : chosen) {
                const Vec3 direction = pixel_direction(camera, at), up = glm::normalize(camera.eye);
                const Hit truth = *hit(object, camera.eye, direction);
                const Vec3 place = camera.eye + truth.distance_m * direction;
                const View view = {eye_m * m, angle(direction, up), angle(sun, up),
                                   angle(direction - glm::dot(direction, up) * up, sun - glm::dot(sun, up) * up)};
                const AerialPerspective before = must(sky->aerial_perspective(view, truth.distance_m * m));
                const double altitude = glm::length(place) - bottom_m, zenith = angle(place, sun);
                const std::vector<double> sunlight = must(sky->sunlight_transmittance(std::min(altitude, top_m) * m, zenith));
                const std::vector<double> left = skylight_left(*sky, std::min(altitude, top_m) * m);
                const f32::IrradianceSpectrum diffuse = packed.diffuse_on_ground(static_cast<float>(std::cos(zenith)));
                for (std::size_t w = 0; w < 3; ++w) {
                    const double lit =
                        sunlight[w] * atmosphere.sun.irradiance.at(wavelengths[w]).value * std::max(glm::dot(truth.normal, sun), 0.0) +
                        left[w] * (0.5 + 0.5 * glm::dot(truth.normal, glm::normalize(place))) * static_cast<double>(diffuse.v[w]);
                    const double expected = before.inscattered_W_m2_sr_nm[w] + before.transmittance[w] * reflectance / pi * lit;
                    const double seen = static_cast<double>(pixels[4 * at + 2 - w]);
                    if (w == 1) fmt::print("  {:>6.0f} {:>20.0f} {:>24.4g} {:>12.4g}\n", eye_m, altitude, expected, seen);
                    CHECK(std::abs(seen - expected) <= 0.03 * expected + 1e-7);
                }
            }
        }
}
