// The ground through the GPU: what is drawn is the ground, and a flight from 20 000 km to 2 m shows no crack, no jump, nothing
// that is not a number, in bounded memory. AIRLIGHT_FLIGHT=full flies 600 frames; AIRLIGHT_PICTURES=<folder> keeps some.

#include <doctest/doctest.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "image/png.h"
#include "render/camera_block.h"
#include "render/ground_pass.h"
#include "render/light_pass.h"
#include "render/terrain_pass.h"
#include "terrain/procedural_relief.h"
#include "tools/gpu_case.h"
#include "tools/must.h"

using namespace airlight;
using namespace airlight::test;

namespace {

struct Frame {
    std::vector<float> depth, colour, light;  // the first row is the lowest
};

// All that draws one size of picture.
class Scene {
public:
    Scene(int width, int height, const HeightField& field, render::TerrainMemory memory = {})
        : Scene(width, height, must(render::TerrainPass::create(field, detail(height), memory))) {}
    // Of the ground of another.
    Scene(int width, int height, const Scene& other)
        : Scene(width, height,
                must(render::TerrainPass::create(other.terrain_.quadtree().field(), detail(height), {}, other.terrain_.tiles()))) {}
    Scene(int width, int height, render::TerrainPass terrain)
        : width_(width),
          height_(height),
          light_texture_({width, height}),
          surfaces_(must(render::GeometryBuffer::create(width, height))),
          target_(must(gpu::Framebuffer::create({&light_texture_}))),
          light_(must(render::LightPass::create())),
          terrain_(std::move(terrain)),
          ground_(must(render::GroundPass::create(terrain_.quadtree().field()))) {}

    Frame draw(Camera camera, Vec3 towards_sun, Culling culling = {}) {
        camera.width = width_, camera.height = height_;
        camera_.bind(camera);
        surfaces_.begin();
        terrain_.draw(camera, culling);
        ground_.draw(surfaces_, camera);
        render::GeometryBuffer::end();
        target_.bind();
        light_.draw(surfaces_, {towards_sun, Vec3(pi), Vec3(0.25)});
        const auto pixels = static_cast<std::size_t>(width_ * height_);
        Frame frame{std::vector<float>(pixels), std::vector<float>(4 * pixels), std::vector<float>(4 * pixels)};
        surfaces_.depth().read(frame.depth);
        surfaces_.colour().read(frame.colour);
        light_texture_.read(frame.light);
        return frame;
    }

    const render::TerrainPass& terrain() const { return terrain_; }

private:
    static DetailSettings detail(int height) {
        return {.pixels_per_radian = 0.5 * height / std::tan(30.0 * deg), .pixels_of_error = 1.0, .pixels_of_square = 8.0};
    }

    int width_, height_;
    gpu::Texture light_texture_;
    render::GeometryBuffer surfaces_;
    gpu::Framebuffer target_;
    render::LightPass light_;
    render::TerrainPass terrain_;
    render::GroundPass ground_;
    render::CameraBlock camera_;
};

// On the way down above one place: looking at the limb from afar, at the horizon from near.
Camera camera_at(const HeightField& field, double above_m) {
    const Vec3 zenith = direction_of(38.0 * deg, 21.0 * deg);
    const double ground = std::max(0.0, field.sample(zenith, 1.0).height_m);
    const double dip = std::acos(field.radius_m / (field.radius_m + above_m));
    return look(
        Viewpoint{
            .latitude = 38.0 * deg, .longitude = 21.0 * deg, .altitude_m = ground + above_m, .heading = 60.0 * deg, .pitch = -dip - 0.1},
        field.radius_m);
}

double altitude_of(int frame, int frames) { return 2e7 * std::pow(2.0 / 2e7, static_cast<double>(frame) / (frames - 1)); }

void keep_picture(const Frame& frame, int width, int height, const std::string& name) {
    const char* folder = std::getenv("AIRLIGHT_PICTURES");
    if (!folder) return;
    Image image(width, height, 3);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            for (int c = 0; c < 3; ++c) {
                const float light = frame.light[static_cast<std::size_t>(4 * ((height - 1 - row) * width + column) + c)];
                image.pixel(column, row)[static_cast<std::size_t>(c)] = std::clamp(2.5f * light, 0.0f, 1.0f);
            }
    CHECK(write_png(std::filesystem::path(folder) / (name + ".png"), image));
}

double nearest_to_centre(Vec3 eye, Vec3 way) {
    const double along = std::max(0.0, -glm::dot(eye, way));
    return glm::length(eye + along * way);
}

}  // namespace

TEST_CASE("a flight from 20 000 km to 2 m has no crack, nothing that is not a number, and bounded memory") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    constexpr int width = 160, height = 90;
    const bool full = std::getenv("AIRLIGHT_FLIGHT") != nullptr;
    const int frames = full ? 600 : 60;
    const HeightField field = procedural_height({});
    const render::TerrainMemory memory{.tiles_bytes = 8 << 20, .gpu_tiles = 300};
    Scene scene(width, height, field, memory);
    const Vec3 sun = glm::normalize(direction_of(20.0 * deg, -20.0 * deg));
    std::size_t most_patches = 0, must_be_ground = 0, ground_pixels = 0, slivers = 0;
    for (int n = 0; n < frames; ++n) {
        Camera camera = camera_at(field, altitude_of(n, frames));
        camera.width = width, camera.height = height;
        CAPTURE(altitude_of(n, frames));
        const Frame frame = scene.draw(camera, sun);
        const double solid = scene.terrain().quadtree().solid_m(camera.eye), top = field.radius_m + field.whole.high;
        int holes = 0, ghosts = 0, misplaced = 0, strange = 0, cracks = 0;
        const auto covered = [&](int column, int row) {
            return frame.colour[static_cast<std::size_t>(4 * (row * width + column) + 3)] == 1.0f;
        };
        for (int row = 0; row < height; ++row)
            for (int column = 0; column < width; ++column) {
                const Vec3 way = direction_at(camera, (column + 0.5) / width * 2.0 - 1.0, (row + 0.5) / height * 2.0 - 1.0);
                const double least = nearest_to_centre(camera.eye, way);
                const auto pixel = static_cast<std::size_t>(row * width + column);
                must_be_ground += least < solid;
                holes += least < solid && !covered(column, row);
                ghosts += least > top && covered(column, row);
                for (int c = 0; c < 4; ++c) strange += !std::isfinite(frame.light[4 * pixel + static_cast<std::size_t>(c)]);
                if (covered(column, row)) {
                    const double distance = render::near_m / static_cast<double>(frame.depth[pixel]) / glm::dot(way, camera.forward);
                    const auto placed = [&](double at_m) {
                        const double r = glm::length(camera.eye + at_m * way), rounding = 1e-6 * at_m;
                        return r > solid - rounding && r < top + rounding;
                    };
                    ++ground_pixels;
                    slivers += !placed(distance);
                    // By a twentieth of the distance, the size of a triangle.
                    misplaced += !placed(distance) && !placed(0.95 * distance) && !placed(1.05 * distance) && !placed(0.98 * distance) &&
                                 !placed(1.02 * distance);
                } else if (row > 0 && row + 1 < height && column > 0 && column + 1 < width) {
                    cracks += covered(column - 1, row) && covered(column + 1, row) && covered(column, row - 1) && covered(column, row + 1);
                }
            }
        CHECK(holes == 0);
        CHECK(ghosts == 0);
        CHECK(misplaced == 0);
        CHECK(strange == 0);
        CHECK(cracks == 0);
        CHECK(scene.terrain().tiles_bytes() <= memory.tiles_bytes);
        most_patches = std::max(most_patches, scene.terrain().count().patches);
        if (n % (frames / 15) == 0) keep_picture(frame, width, height, fmt::format("flight-{:03}", n));
    }
    // Triangles seen edge-on at a limb are narrower than the rasterizer's steps: their depth is known to their own size only.
    CHECK(static_cast<double>(slivers) <= 2.0 + 1e-6 * static_cast<double>(ground_pixels));
    fmt::print("  {} of {} pixels beside the ground, by less than a triangle\n", slivers, ground_pixels);
    fmt::print("  {} frames, at most {} patches; {} pixels had to be ground\n", frames, most_patches, must_be_ground);
    CHECK(most_patches <= 800);  // more than the GPU holds at once: then they are drawn in batches
    CHECK(must_be_ground > static_cast<std::size_t>(frames * width * height / 4));
}

TEST_CASE("a flight has no jump: as the eye moves by a thousandth of its altitude, the picture changes by about as little everywhere") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    constexpr int width = 160, height = 90, places = 24;
    const HeightField field = procedural_height({});
    Scene scene(width, height, field);
    const Vec3 sun = glm::normalize(direction_of(20.0 * deg, -20.0 * deg));
    std::vector<double> changes;
    for (int n = 0; n < places; ++n) {
        const double above_m = altitude_of(n, places);
        const Frame a = scene.draw(camera_at(field, above_m), sun), b = scene.draw(camera_at(field, above_m * 1.001), sun);
        double change = 0.0, light = 0.0;
        for (std::size_t i = 0; i < a.light.size(); ++i) {
            change += std::abs(static_cast<double>(a.light[i]) - static_cast<double>(b.light[i]));
            light += static_cast<double>(a.light[i]);
        }
        changes.push_back(change / light);
    }
    std::sort(changes.begin(), changes.end());
    fmt::print("  change of light: median {:.4f}, largest {:.4f}\n", changes[places / 2], changes.back());
    CHECK(changes.back() < 0.02);
}

// A pixel of projected error is asked for. Found: 0.08 in the median and 0.8 at the 99th of a hundred, 2 m above the ground.
TEST_CASE("what is drawn is the ground: the height at a pixel's rebuilt place is the field's, to within two pixels") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    constexpr int width = 160, height = 90;
    const HeightField field = procedural_height({});
    Scene scene(width, height, field);
    for (const double above_m : {2.0, 100.0, 5e3, 2e5, 5e6}) {
        Camera camera = camera_at(field, above_m);
        camera.width = width, camera.height = height;
        CAPTURE(above_m);
        const Frame frame = scene.draw(camera, camera.up);
        std::vector<double> errors;
        for (int row = 0; row < height; ++row)
            for (int column = 0; column < width; ++column) {
                const float depth = frame.depth[static_cast<std::size_t>(row * width + column)];
                if (depth == 0.0f) continue;
                const Vec3 way = direction_at(camera, (column + 0.5) / width * 2.0 - 1.0, (row + 0.5) / height * 2.0 - 1.0);
                const double distance = render::near_m / static_cast<double>(depth) / glm::dot(way, camera.forward);
                const Vec3 p = camera.eye + distance * way;
                const double ground = std::max(0.0, field.sample(glm::normalize(p), 1.0).height_m);
                errors.push_back(std::abs(glm::length(p) - field.radius_m - ground) * pixels_per_radian(camera) / distance);
            }
        std::sort(errors.begin(), errors.end());
        REQUIRE(errors.size() > 1000);
        fmt::print("  from {:>9.0f} m: heights are off by {:.3f} pixels in the median, {:.2f} at the 99th of a hundred\n", above_m,
                   errors[errors.size() / 2], errors[errors.size() * 99 / 100]);
        CHECK(errors[errors.size() / 2] < 0.2);
        CHECK(errors[errors.size() * 99 / 100] < 1.6);
    }
}

TEST_CASE("culling changes no pixel") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const HeightField field = procedural_height({});
    Scene scene(160, 90, field);
    for (const double above_m : {2.0, 3000.0, 4e5, 1e7}) {
        const Camera camera = camera_at(field, above_m);
        const Frame culled = scene.draw(camera, camera.up);
        const std::size_t patches = scene.terrain().count().patches;
        const Frame whole = scene.draw(camera, camera.up, {.frustum = false, .horizon = false});
        CHECK(patches < scene.terrain().count().patches);
        CHECK((culled.depth == whole.depth));
        CHECK((culled.light == whole.light));
    }
}

TEST_CASE("a pass that is made anew, for the same size or another, takes over the tiles, and draws what it would with its own") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const HeightField field = procedural_height({});
    const Camera camera = camera_at(field, 3e3);
    Scene first(64, 36, field);
    const Frame before = first.draw(camera, camera.up);
    CHECK(first.terrain().count().built > 0);
    Scene again(64, 36, first);
    const Frame after = again.draw(camera, camera.up);
    CHECK(again.terrain().count().built == 0);
    CHECK((after.depth == before.depth));
    CHECK((after.colour == before.colour));
    Scene larger(96, 54, first), own(96, 54, field);
    CHECK((larger.draw(camera, camera.up).depth == own.draw(camera, camera.up).depth));
    CHECK(larger.terrain().count().built < own.terrain().count().built);
}
