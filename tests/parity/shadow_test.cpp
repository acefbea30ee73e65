// The sun's shadow maps against rays through the field of heights on the CPU, from the ground to space, by day and at sunset.
// AIRLIGHT_PICTURES=<folder> keeps the masks.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "core/parallel.h"
#include "image/png.h"
#include "render/camera_block.h"
#include "render/geometry_buffer.h"
#include "render/shadow_pass.h"
#include "terrain/procedural_relief.h"
#include "terrain/raster_relief.h"
#include "tools/full_screen.h"
#include "tools/gpu_case.h"
#include "tools/object_rays.h"

using namespace airlight;
using namespace airlight::test;

namespace {

constexpr int width = 80, height = 45;

// The mask of a view: for each pixel, 1 where the sun sees its surface; and the depths.
struct Masked {
    std::vector<float> visibility, depth;  // the first row is the lowest
};

class Scene {
public:
    explicit Scene(const HeightField& field, std::span<const Object> objects = {})
        : objects_(must(render::ObjectPass::create(objects))),
          terrain_(must(render::TerrainPass::create(
              field, {.pixels_per_radian = 0.5 * height / std::tan(30.0 * deg), .pixels_of_error = 1.0, .pixels_of_square = 5.0}))) {}

    Masked draw(const Camera& camera, Vec3 towards_sun) {
        camera_.bind(camera);
        surfaces_.begin();
        terrain_.draw(camera);
        objects_.draw();
        render::GeometryBuffer::end();
        shadows_.draw(terrain_, objects_, camera, towards_sun);
        shadows_.bind();
        target_.bind();
        surfaces_.depth().bind_sampler(0);
        mask_.draw();
        Masked masked{std::vector<float>(4 * width * height), std::vector<float>(width * height)};
        texture_.read(masked.visibility);
        surfaces_.depth().read(masked.depth);
        return masked;
    }

    const render::ShadowPass& shadows() const { return shadows_; }

private:
    gpu::Texture texture_{{width, height}};
    render::GeometryBuffer surfaces_ = must(render::GeometryBuffer::create(width, height));
    gpu::Framebuffer target_ = must(gpu::Framebuffer::create({&texture_}));
    render::ObjectPass objects_;
    render::TerrainPass terrain_;
    render::ShadowPass shadows_ = must(render::ShadowPass::create());
    render::CameraBlock camera_;
    FullScreen mask_{"mask", R"(#version 450 core
#include "camera.glsl"
#include "shadow.glsl"
layout(binding = 0) uniform sampler2D depth_buffer;
layout(location = 0) in vec2 place;
layout(location = 0) out vec4 seen;
void main() {
    float depth = texelFetch(depth_buffer, ivec2(gl_FragCoord.xy), 0).r;
    seen = vec4(depth > 0.0 ? sun_visibility(position_at(place, depth)) : 1.0);
}
)"};
};

double ground_m(const HeightField& field, Vec3 p) {
    const double h = field.sample(glm::normalize(p), 1.0).height_m;
    return field.sea ? std::max(h, 0.0) : h;
}

// What the field says of a point: the sun sees it, the ground hides it, or it is too near the edge between the two to say: the ray passes
// the ground within `margin_m`, or within a third of how high it has risen above the horizontal.
enum class Seen { lit, shadowed, edge };
Seen cast(const HeightField& field, Vec3 from, Vec3 towards_sun, double margin_m) {
    bool doubtful = false;
    const double rise = glm::dot(glm::normalize(from), towards_sun) / 3.0;
    for (double t = margin_m; t < 2e6;) {
        const Vec3 p = from + t * towards_sun;
        const double above = glm::length(p) - field.radius_m;
        if (above > field.whole.high && glm::dot(p, towards_sun) > 0.0) break;
        const double clear = above > field.whole.high ? above - field.whole.high : above - ground_m(field, p);
        if (clear < -margin_m) return Seen::shadowed;
        doubtful = doubtful || clear < std::min(margin_m, rise * t);
        t += std::max(0.5 * margin_m, 0.4 * clear);
    }
    return doubtful ? Seen::edge : Seen::lit;
}

// Whether a ray from a point meets an object that is so much larger on all sides.
bool stops(Object object, double larger_m, Vec3 from, Vec3 direction) {
    object.half_size_m += larger_m;
    const std::optional<RayInObject> way = ray_in(object, from, direction);
    return way && way->leaves_m > 0.0;
}

void keep_picture(const Masked& masked, const std::string& name) {
    const char* folder = std::getenv("AIRLIGHT_PICTURES");
    if (!folder) return;
    Image image(width, height, 3);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const auto at = static_cast<std::size_t>((height - 1 - row) * width + column);
            for (std::size_t c = 0; c < 3; ++c)
                image.pixel(column, row)[c] = masked.depth[at] > 0.0f || c == 2 ? masked.visibility[4 * at] : 0.0f;
        }
    CHECK(write_png(std::filesystem::path(folder) / (name + ".png"), image));
}

struct Counts {
    std::size_t edges = 0, sure = 0, shadowed = 0, leaks = 0, acne = 0;
};

Counts compare(const HeightField& field, const Camera& camera, const Masked& masked, const render::ShadowPass& shadows, Vec3 sun) {
    std::vector<Seen> truth(width * height, Seen::edge);
    parallel_for(width * height, [&](std::size_t at) {
        if (masked.depth[at] == 0.0f) return;
        const double x = (static_cast<double>(at % width) + 0.5) / width * 2.0 - 1.0,
                     y = (static_cast<double>(at / width) + 0.5) / height * 2.0 - 1.0;
        const Vec3 way = direction_at(camera, x, y);
        const double distance = render::near_m / static_cast<double>(masked.depth[at]) / glm::dot(way, camera.forward);
        Vec3 p = camera.eye + distance * way;
        const double above = glm::length(p) - field.radius_m, ground = ground_m(field, p);
        p *= (field.radius_m + std::max(above, ground)) / (field.radius_m + above);
        const auto cascade = std::find_if(shadows.cascades().begin(), shadows.cascades().end(),
                                          [&](const render::Cascade& c) { return distance <= c.to_m; });
        REQUIRE(cascade != shadows.cascades().end());
        truth[at] = cast(field, p, sun, 2.0 * cascade->texel_m);
    });
    Counts counts;
    for (std::size_t at = 0; at < truth.size(); ++at) {
        if (masked.depth[at] == 0.0f) continue;
        counts.edges += truth[at] == Seen::edge;
        counts.sure += truth[at] != Seen::edge;
        counts.shadowed += truth[at] == Seen::shadowed;
        counts.leaks += truth[at] == Seen::shadowed && masked.visibility[4 * at] > 0.5f;
        counts.acne += truth[at] == Seen::lit && masked.visibility[4 * at] < 0.5f;
    }
    return counts;
}

}  // namespace

TEST_CASE("a surface is in the sun where the field of heights leaves its light a way") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const HeightField field = procedural_height({.sea = false});
    Scene scene(field);
    const double latitude = 36.2 * deg, longitude = 31.5 * deg;
    fmt::print("  {:>8} {:>5} {:>9} {:>10} {:>9} {:>9} {:>9} {:>9}\n", "eye, m", "sun", "cascades", "patches", "edges, %", "shadow, %",
               "leaks, %", "acne, %");
    for (const auto& [above_m, pitch_deg] : {std::pair{2.0, -3.0}, {3e3, -15.0}, {4e5, -35.0}})
        for (const double sun_deg : {50.0, 80.0, 87.0, 88.0}) {
            const double ground = field.sample(direction_of(latitude, longitude), 1.0).height_m;
            Camera camera = look(Viewpoint{.latitude = latitude,
                                           .longitude = longitude,
                                           .altitude_m = ground + above_m,
                                           .heading = 55.0 * deg,
                                           .pitch = pitch_deg * deg},
                                 field.radius_m);
            camera.width = width, camera.height = height;
            const Vec3 sun =
                look(Viewpoint{.latitude = latitude, .longitude = longitude, .heading = 300.0 * deg, .pitch = (90.0 - sun_deg) * deg},
                     field.radius_m)
                    .forward;
            const Masked masked = scene.draw(camera, sun);
            keep_picture(masked, fmt::format("shadow-{:.0f}-{:.0f}", above_m, sun_deg));
            const Counts n = compare(field, camera, masked, scene.shadows(), sun);
            const auto percent = [&](std::size_t part, std::size_t of) {
                return 100.0 * static_cast<double>(part) / static_cast<double>(of);
            };
            fmt::print("  {:>8.0f} {:>5.0f} {:>9} {:>10} {:>9.1f} {:>9.1f} {:>9.2f} {:>9.2f}\n", above_m, sun_deg,
                       scene.shadows().cascades().size(), scene.shadows().patches(), percent(n.edges, n.edges + n.sure),
                       percent(n.shadowed, n.sure), percent(n.leaks, n.sure), percent(n.acne, n.sure));
            CHECK(percent(n.leaks, n.sure) < 0.5);
            CHECK(percent(n.acne, n.sure) < 0.5);
        }
}

// A sphere of 100 m that floats over level ground, a box and a cylinder that stand on it. Edges are soft by two texels and may lie one
// beside; where a wall meets the ground half a texel of bias lets a twentieth of the light in.
TEST_CASE("the shadow of an object lies where the sun's rays that it stops would have met the ground") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const HeightField field = level_height(6.371e6);
    const Camera level = look(Viewpoint{.latitude = 0.7, .longitude = 0.2, .altitude_m = 0.0}, field.radius_m);
    const auto at = [&](double right, double forward, double up) {
        return level.eye + right * level.right + forward * level.forward + up * level.up;
    };
    const auto object = [&](Shape shape, Vec3 centre, Vec3 half_size_m) {
        return Object{shape, centre, level.right, level.forward, level.up, half_size_m, Vec3(0.5)};
    };
    const std::array objects = {object(Shape::sphere, at(0.0, 0.0, 300.0), Vec3(100.0)),
                                object(Shape::box, at(300.0, 100.0, 60.0), Vec3(40.0, 20.0, 60.0)),
                                object(Shape::cylinder, at(-300.0, 100.0, 60.0), Vec3(40.0, 40.0, 60.0))};
    Scene scene(field, objects);
    // From above, so that the ground is seen under the sphere as well.
    Camera camera = look(at(0.0, -500.0, 600.0), at(0.0, 100.0, 0.0) - at(0.0, -500.0, 600.0), level.up);
    camera.vertical_field_of_view = 40.0 * deg;
    camera.width = width, camera.height = height;
    for (const double sun_deg : {20.0, 60.0, 80.0}) {
        const Vec3 sun =
            glm::normalize(std::cos(sun_deg * deg) * level.up + std::sin(sun_deg * deg) * (0.8 * level.right - 0.6 * level.forward));
        const Masked masked = scene.draw(camera, sun);
        keep_picture(masked, fmt::format("objects-{:.0f}", sun_deg));
        std::size_t shadowed = 0, wrong = 0;
        for (std::size_t i = 0; i < masked.depth.size(); ++i) {
            if (masked.depth[i] == 0.0f) continue;
            const Vec3 way = direction_at(camera, (static_cast<double>(i % width) + 0.5) / width * 2.0 - 1.0,
                                          (static_cast<double>(i / width) + 0.5) / height * 2.0 - 1.0);
            const double distance = render::near_m / static_cast<double>(masked.depth[i]) / glm::dot(way, camera.forward);
            const Vec3 p = camera.eye + distance * way;
            if (glm::length(p) - field.radius_m > 0.5) continue;  // on an object
            const auto cascade = std::find_if(scene.shadows().cascades().begin(), scene.shadows().cascades().end(),
                                              [&](const render::Cascade& c) { return distance <= c.to_m; });
            REQUIRE(cascade != scene.shadows().cascades().end());
            const auto stopped = [&](double larger_m) {
                return std::ranges::any_of(objects, [&](const Object& o) { return stops(o, larger_m, p, sun); });
            };
            const double margin = 3.0 * cascade->texel_m;
            const bool surely = stopped(-margin), maybe = stopped(margin);
            shadowed += surely;
            wrong += (surely && masked.visibility[4 * i] > 0.1f) || (!maybe && masked.visibility[4 * i] < 0.99f);
        }
        fmt::print("  sun {:.0f} degrees from the zenith: {} pixels in the shadow, {} wrong\n", sun_deg, shadowed, wrong);
        CHECK(shadowed > 50);
        CHECK(wrong == 0);
    }
}

TEST_CASE("shadow maps stay while the camera moves little, and are the same whatever was drawn before") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const HeightField field = procedural_height({.sea = false});
    const auto camera_at = [&](double altitude_m, double heading_deg) {
        Camera camera = look(
            Viewpoint{
                .latitude = 36.2 * deg, .longitude = 31.5 * deg, .altitude_m = altitude_m, .heading = heading_deg * deg, .pitch = -0.2},
            field.radius_m);
        camera.width = width, camera.height = height;
        return camera;
    };
    const Camera level = camera_at(0.0, 300.0);
    const Vec3 sun = glm::normalize(level.right + 0.3 * level.up);
    const Object ball{Shape::sphere, level.eye + 5000.0 * level.up + 800.0 * level.right, level.right, level.forward, level.up, Vec3(200.0),
                      Vec3(0.5)};
    Scene scene(field, std::span(&ball, 1)), other(field, std::span(&ball, 1));
    scene.draw(camera_at(5000.0, 10.0), sun);
    CHECK(scene.shadows().patches() > 0);
    scene.draw(camera_at(5000.2, 10.01), sun);
    CHECK(scene.shadows().patches() == 0);
    scene.draw(camera_at(5200.0, 40.0), sun);
    CHECK(scene.shadows().patches() > 0);
    CHECK(scene.draw(camera_at(5100.0, 70.0), sun).visibility == other.draw(camera_at(5100.0, 70.0), sun).visibility);
    scene.draw(camera_at(5100.0, 70.0), glm::normalize(sun + Vec3(1e-3, 0.0, 0.0)));
    CHECK(scene.shadows().patches() > 0);
}

TEST_CASE("the sun at the horizon, through a telescope: shadow maps take no more ground than their texels can show") {
    const HeightField field = procedural_height({});
    const auto patches = [&](double longitude_deg, double zenith_deg) {
        const Viewpoint place{.longitude = longitude_deg * deg, .altitude_m = 10.0, .heading = 270.0 * deg, .pitch = 0.8 * deg};
        Camera camera = look(place, field.radius_m + std::max(0.0, field.sample(direction_of(0.0, place.longitude), 1.0).height_m));
        camera.vertical_field_of_view = 4.0 * deg;
        const render::LightAxes axes = render::light_axes(
            look(Viewpoint{.longitude = place.longitude, .heading = place.heading, .pitch = (90.0 - zenith_deg) * deg}, field.radius_m)
                .forward);
        Quadtree tree(field, level_reach(field, {.pixels_per_radian = pixels_per_radian(camera)}));
        std::size_t sum = 0;
        for (const render::Cascade& c : render::cascades(camera, axes, field, 1024))
            sum += tree.select(c.eye, render::casters_of(c, axes, field)).nodes.size();
        return sum;
    };
    // All that the eye's level of detail has in the maps' columns: 178 040 over the sea, 206 326 over land.
    CHECK(patches(-140.0, 90.1) < 4'000);
    CHECK(patches(31.5, 89.0) < 40'000);
}

TEST_CASE("shadow maps do not crawl: whatever the eye does, texels stay as wide and where they are") {
    const HeightField field = procedural_height({});
    const render::LightAxes axes = render::light_axes(glm::normalize(Vec3(0.3, -0.5, 0.8)));
    std::vector<render::Cascade> first;
    for (int n = 0; n < 40; ++n) {
        Camera camera = look(
            Viewpoint{
                .latitude = 0.6 + 1e-6 * n, .longitude = 0.5, .altitude_m = 9000.0 + 1.7 * n, .heading = 0.16 * n, .pitch = 0.02 * n - 0.4},
            field.radius_m);
        const std::vector<render::Cascade> all = render::cascades(camera, axes, field, 1024);
        if (n == 0) first = all;
        REQUIRE(all.size() == first.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            CHECK(all[i].texel_m == first[i].texel_m);
            for (const double corner : {all[i].centre.x, all[i].centre.y})
                CHECK(std::abs(std::remainder(corner, all[i].texel_m)) < 1e-5 * all[i].texel_m + 1e-8);
        }
    }
}

TEST_CASE("a shadow map holds all that the camera sees at its distances, with what a filter reaches beyond") {
    const HeightField field = procedural_height({});
    const render::LightAxes axes = render::light_axes(glm::normalize(Vec3(0.3, -0.5, 0.8)));
    for (const double altitude_m : {2.0, 9000.0, 4e5, 2e7})
        for (const double field_of_view : {10.0 * deg, 60.0 * deg, 110.0 * deg}) {
            Camera camera =
                look(Viewpoint{.latitude = 0.6, .longitude = 0.5, .altitude_m = altitude_m, .heading = 1.0, .pitch = -0.3}, field.radius_m);
            camera.vertical_field_of_view = field_of_view;
            for (const render::Cascade& c : render::cascades(camera, axes, field, 1024))
                for (const double distance : {c.from_m, 0.5 * (c.from_m + c.to_m), c.to_m})
                    for (const double x : {-1.0, 0.0, 1.0})
                        for (const double y : {-1.0, 0.3, 1.0}) {
                            const Vec3 p = camera.eye + distance * direction_at(camera, x, y);
                            const double beyond = 3.0 * c.texel_m;
                            CHECK(std::abs(glm::dot(p, axes.right) - c.centre.x) <= c.half_width_m - beyond);
                            CHECK(std::abs(glm::dot(p, axes.up) - c.centre.y) <= c.half_width_m - beyond);
                            CHECK(glm::dot(p, axes.towards_sun) >= c.lowest_m);
                        }
        }
}
