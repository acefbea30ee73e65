// What a whole frame takes, pass by pass, by the GPU's own clock: mountains, their shadows and shafts, the air of `airlight`, exposure and
// tone curve; from the ground, from between peaks and from orbit, by an eye at rest and by one that flies. Tiles near by are there already. The
// mean of all frames; 640 x 360 and 1920 x 1080. And how often a flight makes anew what frames share.

#include <benchmark/benchmark.h>
#include <epoxy/gl.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "atmosphere/presets.h"
#include "gpu/context.h"
#include "render/air_airlight.h"
#include "render/exposure_pass.h"
#include "render/frame.h"
#include "render/tone_pass.h"
#include "spectrum/colour.h"
#include "spectrum/colour_weights.h"
#include "terrain/procedural_relief.h"
#include "transport/table_cache.h"

using namespace airlight;

namespace {

constexpr double speed_of_sound = 340.0;

struct Way {
    double above_m, pitch_deg, metres_a_second;
};

// Flies straight ahead, over the ground's height where it began.
Camera camera_on(const Way& way, const HeightField& field, double seconds) {
    constexpr double latitude = 36.2 * deg, longitude = 31.5 * deg;
    const double ground_m = std::max(0.0, field.sample(direction_of(latitude, longitude), 1.0).height_m);
    return look(
        Viewpoint{
            .latitude = latitude + way.metres_a_second * seconds / field.radius_m,
            .longitude = longitude,
            .altitude_m = ground_m + way.above_m,
            .heading = 20.0 * deg,
            .pitch = way.pitch_deg * deg,
        },
        field.radius_m);
}

// 20 degrees high where a flight begins.
Vec3 sun_over(const HeightField& field, double azimuth_deg) {
    return look(Viewpoint{.latitude = 36.2 * deg, .longitude = 31.5 * deg, .heading = azimuth_deg * deg, .pitch = 20.0 * deg},
                field.radius_m)
        .forward;
}

Result<render::Frame> frame_over(const HeightField& field, const gpu::Context& context, const Camera& camera) {
    Atmosphere air = *preset("earth-clear");
    air.bottom_radius = field.radius_m * m;
    const WavelengthGrid grid = WavelengthGrid::standard();
    const std::vector<Wavelength> wavelengths(grid.begin(), grid.end());
    const RgbConverter converter(RgbSpace::srgb, WhitePoint::d65);
    std::vector<Vec3> colours;
    for (const Xyz& weight : ColourWeights(grid, air.sun.irradiance).weights()) {
        const Rgb rgb = converter.to_rgb(weight);
        colours.emplace_back(rgb.r, rgb.g, rgb.b);
    }
    const Result<Tables> tables = cached_tables(air, wavelengths, {}, {}, {});
    if (!tables) return tables.error();
    Result<std::unique_ptr<render::AirMethod>> method = render::airlight_air(*tables, colours);
    if (!method) return method.error();
    Result<render::AirPass> pass = render::AirPass::create({air, wavelengths, colours}, *std::move(method));
    if (!pass) return pass.error();
    Result<render::ShaftsPass> shafts = render::ShaftsPass::create(camera.width, camera.height, render::Shafts::epipolar, &air);
    if (!shafts) return shafts.error();
    return render::Frame::create(context, field, {}, camera, *std::move(pass), *std::move(shafts));
}

void frame(benchmark::State& state, Way way) {
    const Result<gpu::Context> context = gpu::Context::create();
    if (!context) return state.SkipWithError(context.error().message().c_str());
    const HeightField field = procedural_height({});
    const auto camera_at = [&](double seconds) {
        Camera camera = camera_on(way, field, seconds);
        camera.height = static_cast<int>(state.range(0));
        camera.width = camera.height * 16 / 9;
        return camera;
    };
    const render::Lights lights{.towards_sun = sun_over(field, 300.0), .sun = Vec3(1.0), .sky = Vec3(0.0)};
    Result<render::Frame> drawn = frame_over(field, *context, camera_at(0.0));
    const Result<render::ExposurePass> exposure = render::ExposurePass::create();
    const Result<render::TonePass> tone = render::TonePass::create();
    const gpu::Texture picture({camera_at(0.0).width, camera_at(0.0).height}, {}, gpu::TextureFormat::rgba8);
    const Result<gpu::Framebuffer> target = gpu::Framebuffer::create({&picture});
    if (!drawn) return state.SkipWithError(drawn.error().message().c_str());
    if (!exposure || !tone || !target) return state.SkipWithError("the passes cannot be made");
    gpu::PassTimers timers;
    std::map<std::string, double> sums;
    const auto draw = [&](double seconds) {
        if (!drawn->render(camera_at(seconds), lights)) return;
        {
            const auto pass = timers.time("display");
            exposure->meter(drawn->radiance(), {}, {}, std::numeric_limits<double>::infinity());
            target->bind();
            tone->draw(drawn->radiance(), exposure->exposure(), ToneCurve::filmic);
        }
        for (const gpu::PassTime& time : drawn->times()) sums[time.pass] += time.milliseconds;
        for (const gpu::PassTime& time : timers.read()) sums[time.pass] += time.milliseconds;
        glFinish();
    };
    double seconds = 0.0;
    for (int i = 0; i < 3; ++i) draw(seconds += 1.0 / 60.0);
    sums.clear();
    for ([[maybe_unused]] auto _ : state) draw(seconds += 1.0 / 60.0);
    for (const auto& [name, milliseconds] : sums) state.counters[name + " ms"] = milliseconds / static_cast<double>(state.iterations());
    state.counters["patches"] = static_cast<double>(drawn->terrain().patches);
    state.SetLabel(context->renderer());
}

// How often a flight of a minute at 60 pictures a second makes anew what pictures share: shadow maps, and tables for a settled eye. It goes
// straight towards the sun, the way on which an eye's tables hold for the shortest while.
void made_anew(benchmark::State& state, Way way) {
    const HeightField field = procedural_height({});
    const Vec3 sun = sun_over(field, 0.0);
    constexpr int pictures = 3600;
    int maps = 0, tables = 0;
    for ([[maybe_unused]] auto _ : state) {
        std::array<std::optional<render::Cascade>, render::most_cascades> maps_of;
        std::optional<render::AirEye> eye;
        for (int i = 0; i <= pictures; ++i) {
            Camera camera = camera_on(way, field, i / 60.0);
            camera.width = 640, camera.height = 360;
            const std::vector<render::Cascade> cascades =
                render::cascades(camera, render::light_axes(render::settled_sun(sun)), field, render::ShadowSettings{}.texels);
            for (const render::Cascade& cascade : cascades) {
                std::optional<render::Cascade>& map = maps_of[static_cast<std::size_t>(cascade.level % render::most_cascades)];
                maps += i > 0 && map != cascade;
                map = cascade;
            }
            const double r = glm::length(camera.eye);
            const render::AirEye now = render::settled({r - field.radius_m, glm::dot(camera.eye, sun) / r});
            tables += i > 0 && eye != now;
            eye = now;
        }
    }
    state.counters["maps a second"] = maps / 60.0 / static_cast<double>(state.iterations());
    state.counters["tables a picture"] = static_cast<double>(tables) / pictures / static_cast<double>(state.iterations());
}

}  // namespace

#define AIRLIGHT_FRAME(name, ...)                    \
    BENCHMARK_CAPTURE(frame, name, Way{__VA_ARGS__}) \
        ->ArgName("height")                          \
        ->Arg(360)                                   \
        ->Arg(1080)                                  \
        ->Unit(benchmark::kMillisecond)              \
        ->MeasureProcessCPUTime()                    \
        ->UseRealTime()
AIRLIGHT_FRAME(on_foot_at_rest, 2.0, 3.0, 0.0);
AIRLIGHT_FRAME(on_foot, 2.0, 3.0, 1.5);
AIRLIGHT_FRAME(between_peaks_at_rest, 1500.0, -5.0, 0.0);
AIRLIGHT_FRAME(between_peaks, 1500.0, -5.0, speed_of_sound);
AIRLIGHT_FRAME(in_orbit_at_rest, 400e3, -25.0, 0.0);
AIRLIGHT_FRAME(in_orbit, 400e3, -25.0, 7670.0);
#define AIRLIGHT_MADE_ANEW(name, ...) BENCHMARK_CAPTURE(made_anew, name, Way{__VA_ARGS__})->Iterations(1)->Unit(benchmark::kMillisecond)
AIRLIGHT_MADE_ANEW(on_foot, 2.0, 3.0, 1.5);
AIRLIGHT_MADE_ANEW(between_peaks, 1500.0, -5.0, speed_of_sound);
AIRLIGHT_MADE_ANEW(in_orbit, 400e3, -25.0, 7670.0);
