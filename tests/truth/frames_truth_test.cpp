// Frames of the GPU against the tables of the CPU through the same camera, in physical units: the sky, and the air before mountains and the
// sea, which are black here. How near the tables are to the reference is in docs/accuracy.md.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "core/parallel.h"
#include "figures.h"
#include "render/air_airlight.h"
#include "render/air_hillaire2020.h"
#include "render/bruneton2008_air.h"
#include "render/camera_block.h"
#include "render/terrain_pass.h"
#include "terrain/procedural_relief.h"
#include "tools/air_case.h"
#include "tools/full_screen.h"
#include "tools/gpu_case.h"

using namespace airlight;
using namespace airlight::test;
using truth::full;

namespace {

// On a shore, between mountains.
constexpr double latitude = 36.2 * deg, longitude = 31.5 * deg;

int columns() { return full() ? 48 : 20; }
int rows() { return full() ? 27 : 12; }

// What every method is asked: the ground as the GPU drew it, and what the tables say of each pixel.
struct Question {
    Camera camera;
    Vec3 sun;
    std::vector<float> depth;                  // the lowest row first
    std::vector<std::array<double, 3>> light;  // of red, green and blue, W m-2 sr-1 nm-1
};

class Planet {
public:
    const Atmosphere& air() const { return air_; }
    const Tables& tables() const { return tables_; }

    Question ask(double altitude_m, double sun_deg) {
        const double dip = std::acos(field_.radius_m / (field_.radius_m + altitude_m));
        const auto looking = [&](double heading, double pitch) {
            Camera camera =
                look(Viewpoint{.latitude = latitude, .longitude = longitude, .altitude_m = altitude_m, .heading = heading, .pitch = pitch},
                     field_.radius_m);
            camera.width = columns(), camera.height = rows();
            return camera;
        };
        Question q{looking(30.0 * deg, -dip), looking(75.0 * deg, (90.0 - sun_deg) * deg).forward, {}, {}};
        camera_.bind(q.camera);
        ground_.begin();
        terrain_.draw(q.camera);
        render::GeometryBuffer::end();
        q.depth.resize(static_cast<std::size_t>(columns() * rows()));
        ground_.depth().read(q.depth);
        q.light.resize(q.depth.size());
        parallel_for(q.depth.size(), [&](std::size_t at) { q.light[at] = light_at(q, at); });
        return q;
    }

    // The mean difference of a method's picture, over the mean light: of the sky, and of the air before surfaces.
    std::array<double, 2> errors(render::AirPass& pass, const Question& q) {
        camera_.bind(q.camera);
        ground_.begin();
        terrain_.draw(q.camera);
        render::GeometryBuffer::end();
        surfaces_.begin();
        ground_.depth().bind_sampler(0);
        black_.draw();
        render::GeometryBuffer::end();
        gpu::PassTimers timers;
        pass.prepare(q.camera, q.sun, timers);
        target_.bind();
        REQUIRE(pass.draw(surfaces_));
        std::vector<float> pixels(4 * q.depth.size());
        radiance_.read(pixels);
        std::array<MeanError, 2> errors;
        for (std::size_t at = 0; at < q.depth.size(); ++at)
            for (std::size_t c = 0; c < 3; ++c) errors[q.depth[at] > 0.0f].add(static_cast<double>(pixels[4 * at + c]), q.light[at][c]);
        return {errors[0].value(), errors[1].value()};
    }

private:
    std::array<double, 3> light_at(const Question& q, std::size_t at) const {
        const auto w = static_cast<std::size_t>(columns());
        const Vec3 way = direction_at(q.camera, (static_cast<double>(at % w) + 0.5) / columns() * 2.0 - 1.0,
                                      (static_cast<double>(at / w) + 0.5) / rows() * 2.0 - 1.0);
        const View view = view_of(q.camera.eye, field_.radius_m, way, q.sun);
        const double depth = static_cast<double>(q.depth[at]);
        const std::vector<double> seen =
            depth == 0.0
                ? sky_->radiance(view)->radiance_W_m2_sr_nm
                : sky_->aerial_perspective(view, render::near_m / depth / glm::dot(way, q.camera.forward) * m)->inscattered_W_m2_sr_nm;
        std::array<double, 3> light{};
        for (std::size_t c = 0; c < 3; ++c) light[c] = seen[wavelength_of_channel[c]];
        return light;
    }

    HeightField field_ = procedural_height({});
    TemporaryFolder cache_;
    Atmosphere air_ = [this] {
        Atmosphere air = *preset("earth-clear");
        air.bottom_radius = field_.radius_m * m;
        return air;
    }();
    BakeSettings bake_ =
        full() ? BakeSettings{}
               : BakeSettings{
                     .sizes = {.transmittance_mu = 128, .transmittance_altitude = 32, .sun = 32, .azimuth = 4, .view = 8, .altitude = 12},
                     .orders = 3};
    Tables tables_ = *cached_tables(air_, wavelengths, bake_, {.folder = cache_.path}, {});
    std::unique_ptr<Sky> sky_ = *make_sky("tables", air_, wavelengths, {.bake = bake_, .cache = {.folder = cache_.path}});
    render::TerrainPass terrain_ = must(render::TerrainPass::create(field_, {.pixels_per_radian = 0.5 * rows() / std::tan(30.0 * deg)}));
    render::GeometryBuffer ground_ = must(render::GeometryBuffer::create(columns(), rows())),
                           surfaces_ = must(render::GeometryBuffer::create(columns(), rows()));
    gpu::Texture radiance_{{columns(), rows()}};
    gpu::Framebuffer target_ = must(gpu::Framebuffer::create({&radiance_}, &surfaces_.depth()));
    render::CameraBlock camera_;
    FullScreen black_{"black ground", R"(#version 450 core
#include "geometry_buffer.glsl"
layout(binding = 0) uniform sampler2D depth_buffer;
void main() {
    float depth = texelFetch(depth_buffer, ivec2(gl_FragCoord.xy), 0).r;
    if (depth == 0.0) discard;
    gl_FragDepth = depth;
    write_surface(vec3(0.0), vec3(0.0, 0.0, 1.0), 1.0, 0.0);
}
)"};
};

struct Method {
    std::string_view name;
    double bound;
    render::AirPass pass;
};

std::vector<Method> methods_of(const Planet& planet) {
    const auto pass = [&](Result<std::unique_ptr<render::AirMethod>> method) {
        return must(render::AirPass::create({planet.air(), wavelengths, colours}, must(std::move(method))));
    };
    std::vector<Method> methods;
    methods.push_back({"airlight", 0.03, pass(render::airlight_air(planet.tables(), colours))});
    if (!full()) return methods;
    render::Bruneton2008Bake bake(must(render::bruneton2008_programs()), planet.air(), wavelengths, render::fine_texels,
                                  {.sizes = render::sizes_around_points, .orders = planet.tables().settings().orders});
    methods.push_back({"bruneton2008", 0.05,
                       pass(std::unique_ptr<render::AirMethod>(std::make_unique<render::Bruneton2008Air>(std::move(bake), colours)))});
    return methods;
}

}  // namespace

TEST_CASE(
    "frames are within 3 % of the CPU's light through the same camera, those of tables within 5 %, from 0 m to 20 000 km, at all suns") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    Planet planet;
    std::vector<Method> methods = methods_of(planet);
    const std::vector<double> altitudes_m = full() ? std::vector{1.0, 2e3, 1e4, 3e4, 4e5, 2e7} : std::vector{2e3, 4e5};
    const std::vector<double> suns_deg = full() ? std::vector{0.0, 30.0, 60.0, 75.0, 85.0, 90.0, 93.0, 96.0} : std::vector{30.0, 93.0};
    fmt::print("  mean error, %         ");
    for (const Method& method : methods) fmt::print(" {:>14} before ground", method.name);
    fmt::print("\n");
    for (const double altitude_m : altitudes_m)
        for (const double sun_deg : suns_deg) {
            const Question question = planet.ask(altitude_m, sun_deg);
            fmt::print("  {:>9.0f} m, sun {:>3.0f}   ", altitude_m, sun_deg);
            for (Method& method : methods) {
                CAPTURE(method.name);
                CAPTURE(altitude_m);
                CAPTURE(sun_deg);
                const auto [sky, before] = planet.errors(method.pass, question);
                fmt::print(" {:>14.2f} {:>13.2f}", 100.0 * sky, 100.0 * before);
                CHECK(sky <= method.bound);
                CHECK(before <= method.bound);
            }
            fmt::print("\n");
        }
}
