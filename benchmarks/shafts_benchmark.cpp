// What shadows cost: the shadow maps of a view between mountains, and each method of light shafts. 640 x 360; drawn to the end.

#include <benchmark/benchmark.h>
#include <epoxy/gl.h>

#include <cmath>
#include <memory>

#include "atmosphere/presets.h"
#include "gpu/context.h"
#include "render/air_pass.h"
#include "render/camera_block.h"
#include "render/shafts_pass.h"
#include "terrain/procedural_relief.h"

using namespace airlight;
using render::Shafts;

namespace {

constexpr int width = 640, height = 360;

Camera camera_at(const HeightField& field, double altitude_m, double heading_deg, double pitch_deg) {
    Camera camera = look(Viewpoint{.latitude = 36.2 * deg,
                                   .longitude = 31.5 * deg,
                                   .altitude_m = altitude_m,
                                   .heading = heading_deg * deg,
                                   .pitch = pitch_deg * deg},
                         field.radius_m);
    camera.width = width, camera.height = height;
    return camera;
}

// Tells what the pass of air knows of a frame; is never drawn.
class NoMethod : public render::AirMethod {
public:
    std::string shader() const override { return "air_exact.frag"; }
    void prepare(const render::AirEye&, gpu::PassTimers&) override {}
    int pictures() const override { return 0; }
    void bind(int) const override {}
};

// The view, its ground drawn.
struct Scene {
    HeightField field = procedural_height({});
    Camera camera = camera_at(field, 4500.0, 30.0, -5.0);
    Vec3 sun = camera_at(field, 0.0, 300.0, 5.0).forward;
    render::CameraBlock block;
    Result<render::GeometryBuffer> surfaces = render::GeometryBuffer::create(width, height);
    Result<render::TerrainPass> terrain =
        render::TerrainPass::create(field, {.pixels_per_radian = pixels_per_radian(camera), .pixels_of_square = 5.0}, {.gpu_tiles = 4096});
    Result<render::ObjectPass> objects = render::ObjectPass::create({});
    Result<render::ShadowPass> shadows = render::ShadowPass::create();

    bool ready() {
        if (!surfaces || !terrain || !objects || !shadows) return false;
        block.bind(camera);
        surfaces->begin();
        terrain->draw(camera);
        render::GeometryBuffer::end();
        shadows->draw(*terrain, *objects, camera, sun);
        return true;
    }
};

void shadow_maps(benchmark::State& state) {
    const Result<gpu::Context> context = gpu::Context::create();
    if (!context) return state.SkipWithError(context.error().message().c_str());
    Scene scene;
    if (!scene.ready()) return state.SkipWithError("the passes cannot be made");
    for ([[maybe_unused]] auto _ : state) {
        // Another sun: no map stays.
        scene.sun = glm::normalize(scene.sun + 1e-3 * scene.camera.up);
        scene.shadows->draw(*scene.terrain, *scene.objects, scene.camera, scene.sun);
        glFinish();
    }
    state.counters["cascades"] = static_cast<double>(scene.shadows->cascades().size());
    state.counters["patches"] = static_cast<double>(scene.shadows->patches());
    state.SetLabel(context->renderer());
}

void shafts(benchmark::State& state, Shafts method) {
    const Result<gpu::Context> context = gpu::Context::create();
    if (!context) return state.SkipWithError(context.error().message().c_str());
    Scene scene;
    Atmosphere air = *preset("earth-clear");
    air.bottom_radius = scene.field.radius_m * m;
    const std::vector<Wavelength> wavelengths = {550.0 * nm};
    const std::vector<Vec3> colours = {Vec3(1.0)};
    Result<render::AirPass> view = render::AirPass::create({air, wavelengths, colours}, std::make_unique<NoMethod>());
    const Result<render::ShaftsPass> pass = render::ShaftsPass::create(width, height, method, &air);
    if (!scene.ready() || !view || !pass) return state.SkipWithError("the passes cannot be made");
    gpu::PassTimers timers;
    view->prepare(scene.camera, scene.sun, timers);
    const auto draw = [&] {
        pass->draw(*scene.surfaces, *scene.shadows, scene.camera);
        glFinish();
    };
    draw();
    for ([[maybe_unused]] auto _ : state) draw();
    state.SetLabel(context->renderer());
}

}  // namespace

BENCHMARK(shadow_maps)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK_CAPTURE(shafts, none, Shafts::none)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK_CAPTURE(shafts, epipolar, Shafts::epipolar)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK_CAPTURE(shafts, marched, Shafts::marched)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK_CAPTURE(shafts, planes, Shafts::planes)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK_CAPTURE(shafts, volumes, Shafts::volumes)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK_CAPTURE(shafts, brute, Shafts::brute)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
