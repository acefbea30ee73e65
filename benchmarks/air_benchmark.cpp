// What the air of a frame takes, by method: its tables and its picture, by the GPU's own clock, the best frame of all; and what another
// atmosphere takes.
// Half of the view is sky, half the ground sphere or the sea, with its waves. 640 x 360, earth-clear at sixteen wavelengths.

#include <benchmark/benchmark.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "atmosphere/presets.h"
#include "gpu/context.h"
#include "render/air_airlight.h"
#include "render/air_exact.h"
#include "render/air_hillaire2020.h"
#include "render/air_pass.h"
#include "render/camera_block.h"
#include "render/ground_pass.h"
#include "render/terrain_pass.h"
#include "spectrum/colour.h"
#include "spectrum/colour_weights.h"
#include "transport/table_cache.h"

using namespace airlight;

namespace {

constexpr int width = 640, height = 360;

struct Air {
    Atmosphere atmosphere = *preset("earth-clear");
    WavelengthGrid grid = WavelengthGrid::standard();
    std::vector<Wavelength> wavelengths{grid.begin(), grid.end()};
    std::vector<Vec3> colours;
    Tables tables = *cached_tables(atmosphere, wavelengths, {}, {}, {});
    Air() {
        const RgbConverter converter(RgbSpace::srgb, WhitePoint::d65);
        for (const Xyz& weight : ColourWeights(grid, atmosphere.sun.irradiance).weights()) {
            const Rgb rgb = converter.to_rgb(weight);
            colours.emplace_back(rgb.r, rgb.g, rgb.b);
        }
    }
};

enum Method : int { by_airlight, by_hillaire2020, by_march };
Result<std::unique_ptr<render::AirMethod>> method_of(const Air& air, Method method) {
    if (method == by_march) return render::exact_air(air.tables, air.colours);
    if (method == by_hillaire2020) return render::hillaire2020_air({air.atmosphere, air.wavelengths, air.colours});
    return render::airlight_air(air.tables, air.colours);
}

// A planet under water.
HeightField sea_of(double radius_m) {
    constexpr double floor_m = -1000.0;
    return {
        .radius_m = radius_m,
        .sample =
            [](Vec3, double) {
                return HeightSample{floor_m, Vec3(0.0), Vec3(0.0), Vec3(0.0)};
            },
        .range =
            [](const Cap&) {
                return Interval{floor_m, floor_m};
            },
        .detail = [](double) { return 0.0; },
        .whole = {floor_m, floor_m},
        .sea = true,
    };
}

// Fills the buffer with what the camera sees of it.
Result<Done> draw_sea(const render::GeometryBuffer& surfaces, const Camera& camera, double radius_m) {
    const HeightField sea = sea_of(radius_m);
    Result<render::TerrainPass> terrain =
        render::TerrainPass::create(sea, {.pixels_per_radian = pixels_per_radian(camera), .pixels_of_error = 2.0, .pixels_of_square = 8.0});
    if (!terrain) return terrain.error();
    Result<render::GroundPass> looks = render::GroundPass::create(sea);
    if (!looks) return looks.error();
    surfaces.begin();
    terrain->draw(camera);
    looks->draw(surfaces, camera);
    render::GeometryBuffer::end();
    return Done{};
}

void air(benchmark::State& state) {
    const Result<gpu::Context> context = gpu::Context::create();
    if (!context) return state.SkipWithError(context.error().message().c_str());
    const Air model;
    Result<std::unique_ptr<render::AirMethod>> method = method_of(model, static_cast<Method>(state.range(0)));
    if (!method) return state.SkipWithError(method.error().message().c_str());
    Result<render::AirPass> pass = render::AirPass::create({model.atmosphere, model.wavelengths, model.colours}, *std::move(method));
    const Result<render::GeometryBuffer> surfaces = render::GeometryBuffer::create(width, height);
    const gpu::Texture radiance({width, height});
    const Result<gpu::Framebuffer> target = gpu::Framebuffer::create({&radiance}, &surfaces->depth());
    if (!pass || !surfaces || !target) return state.SkipWithError("the passes cannot be made");
    const double altitude_m = static_cast<double>(state.range(1)), radius_m = model.atmosphere.bottom_radius.in(m);
    const double dip = std::acos(radius_m / (radius_m + altitude_m));
    Camera camera = look(Viewpoint{.latitude = 0.7, .longitude = 0.2, .altitude_m = altitude_m, .heading = 0.5, .pitch = -dip}, radius_m);
    camera.width = width, camera.height = height;
    const Vec3 sun =
        look(Viewpoint{.latitude = 0.7, .longitude = 0.2, .heading = 1.1, .pitch = (90.0 - static_cast<double>(state.range(2))) * deg},
             radius_m)
            .forward;
    const render::CameraBlock block;
    block.bind(camera);
    const bool water = state.range(3) != 0;
    surfaces->begin();
    render::GeometryBuffer::end();
    if (water)
        if (const Result<Done> drawn = draw_sea(*surfaces, camera, radius_m); !drawn)
            return state.SkipWithError(drawn.error().message().c_str());
    gpu::PassTimers timers;
    const auto draw = [&] {
        block.bind(camera);
        pass->prepare(camera, sun, timers);
        const auto timed = timers.time("air");
        target->bind();
        return static_cast<bool>(pass->draw(*surfaces, nullptr, nullptr, water));
    };
    if (!draw()) return state.SkipWithError("the air cannot be drawn");  // compiles what the driver compiles late
    timers.read();
    std::map<std::string, double> best;
    for ([[maybe_unused]] auto _ : state) {
        draw();
        for (const gpu::PassTime& time : timers.read()) {
            const auto [at, first] = best.emplace(time.pass, time.milliseconds);
            if (!first) at->second = std::min(at->second, time.milliseconds);
        }
    }
    for (const auto& [name, milliseconds] : best) state.counters[name + " ms"] = milliseconds;
    state.SetLabel(context->renderer());
}

// From an atmosphere that was edited to its first picture by hillaire2020, by which the viewer draws it until other tables are there.
void edited_air(benchmark::State& state) {
    const Result<gpu::Context> context = gpu::Context::create();
    if (!context) return state.SkipWithError(context.error().message().c_str());
    Air model;
    const Result<render::GeometryBuffer> surfaces = render::GeometryBuffer::create(width, height);
    const gpu::Texture radiance({width, height});
    if (!surfaces) return state.SkipWithError(surfaces.error().message().c_str());
    const Result<gpu::Framebuffer> target = gpu::Framebuffer::create({&radiance}, &surfaces->depth());
    if (!target) return state.SkipWithError(target.error().message().c_str());
    Camera camera = look(Viewpoint{.latitude = 0.7, .longitude = 0.2, .altitude_m = 2.0}, model.atmosphere.bottom_radius.in(m));
    camera.width = width, camera.height = height;
    const render::CameraBlock block;
    surfaces->begin();
    render::GeometryBuffer::end();
    const auto draw = [&](const char* name) {
        model.atmosphere = *preset(name);
        Result<std::unique_ptr<render::AirMethod>> method = method_of(model, by_hillaire2020);
        if (!method) return false;
        Result<render::AirPass> pass = render::AirPass::create({model.atmosphere, model.wavelengths, model.colours}, *std::move(method));
        if (!pass) return false;
        gpu::PassTimers timers;
        block.bind(camera);
        pass->prepare(camera, camera.forward, timers);
        target->bind();
        const bool drawn = static_cast<bool>(pass->draw(*surfaces, nullptr, nullptr, false));
        glFinish();
        return drawn;
    };
    if (!draw("earth-clear")) return state.SkipWithError("the air cannot be drawn");  // compiles what the driver keeps
    bool hazy = false;
    for ([[maybe_unused]] auto _ : state) draw((hazy = !hazy) ? "earth-hazy" : "earth-clear");
    state.SetLabel(context->renderer());
}

}  // namespace

BENCHMARK(edited_air)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(air)
    ->ArgNames({"method", "above_m", "sun_deg", "water"})
    ->ArgsProduct({{by_airlight, by_hillaire2020}, {2, 10'000, 400'000}, {50, 95}, {0, 1}})
    ->Args({by_march, 2, 50, 0})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
