// What frustum and horizon culling save: a frame of the ground with and without, from three heights, as [Sperlhofer2011, fig. 4-25].
// A frame is drawn to its end; tiles are there already. 640 x 360.

#include <benchmark/benchmark.h>
#include <epoxy/gl.h>

#include <cmath>

#include "gpu/context.h"
#include "render/camera_block.h"
#include "render/geometry_buffer.h"
#include "render/ground_pass.h"
#include "render/terrain_pass.h"
#include "terrain/procedural_relief.h"

using namespace airlight;

namespace {

constexpr int width = 640, height = 360;

Camera camera_above(const HeightField& field, double above_m) {
    const Vec3 zenith = direction_of(38.0 * deg, 21.0 * deg);
    const double ground = std::max(0.0, field.sample(zenith, 1.0).height_m);
    const double dip = std::acos(field.radius_m / (field.radius_m + above_m));
    Camera camera = look(
        Viewpoint{
            .latitude = 38.0 * deg, .longitude = 21.0 * deg, .altitude_m = ground + above_m, .heading = 60.0 * deg, .pitch = -dip - 0.1},
        field.radius_m);
    camera.width = width, camera.height = height;
    return camera;
}

void ground(benchmark::State& state) {
    const Result<gpu::Context> context = gpu::Context::create();
    if (!context) return state.SkipWithError(context.error().message().c_str());
    const HeightField field = procedural_height({});
    const Camera camera = camera_above(field, static_cast<double>(state.range(0)));
    const Culling culling{state.range(1) != 0, state.range(2) != 0};
    const render::CameraBlock block;
    const Result<render::GeometryBuffer> surfaces = render::GeometryBuffer::create(width, height);
    Result<render::TerrainPass> terrain =
        render::TerrainPass::create(field, {.pixels_per_radian = pixels_per_radian(camera)}, {.gpu_tiles = 4096});
    const Result<render::GroundPass> looks = render::GroundPass::create(field);
    if (!surfaces || !terrain || !looks) return state.SkipWithError("the passes cannot be made");
    block.bind(camera);
    const auto frame = [&] {
        surfaces->begin();
        terrain->draw(camera, culling);
        looks->draw(*surfaces, camera);
        render::GeometryBuffer::end();
        glFinish();
    };
    frame();
    for ([[maybe_unused]] auto _ : state) frame();
    state.counters["patches"] = static_cast<double>(terrain->count().patches);
    state.SetLabel(context->renderer());
}

}  // namespace

BENCHMARK(ground)
    ->ArgNames({"above_m", "frustum", "horizon"})
    ->ArgsProduct({{2, 10'000, 1'000'000}, {0, 1}, {0, 1}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
