// What the sky from tables costs: the bake, the second start, a dome, a picture, a single direction.
// Air of the preset earth-clear at sixteen wavelengths, on all cores; a direction is on one.

#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>
#include <memory>

#include "atmosphere/presets.h"
#include "sky/sky_image.h"
#include "sky/table_sky.h"
#include "transport/table_cache.h"

using namespace airlight;

namespace {

const Atmosphere& earth() {
    static const Atmosphere atmosphere = *preset("earth-clear");
    return atmosphere;
}

std::vector<Wavelength> sixteen() {
    const WavelengthGrid grid = WavelengthGrid::standard();
    return {grid.begin(), grid.end()};
}

// 64 x 16 x 32 x 32 = 1 048 576 texels of source and 256 x 128 of transmittance: the default.
BakeSettings bake_of(std::int64_t orders) { return {.sizes = {}, .orders = static_cast<int>(orders)}; }

// A folder of its own, which goes with it.
struct CacheFolder {
    CacheFolder() { std::filesystem::create_directories(path); }
    ~CacheFolder() { std::filesystem::remove_all(path); }
    std::filesystem::path path = std::filesystem::temp_directory_path() / "airlight-tables-benchmark";
};

const TableSky& ready_sky() {
    static const TableSky sky(std::make_shared<Tables>(*bake_tables(earth(), sixteen(), bake_of(5), {})));
    return sky;
}

void bake(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(bake_tables(earth(), sixteen(), bake_of(state.range(0)), {}));
}
BENCHMARK(bake)->ArgName("orders")->Arg(4)->Arg(6)->Unit(benchmark::kSecond)->Iterations(1)->UseRealTime();

// The tables of earth-clear from the cache, checked as each start checks them.
void second_start(benchmark::State& state) {
    const CacheFolder folder;
    const CacheSettings cache{.folder = folder.path};
    const auto baked = cached_tables(earth(), sixteen(), bake_of(2), cache, {});
    for (auto _ : state) benchmark::DoNotOptimize(cached_tables(earth(), sixteen(), bake_of(2), cache, {}));
}
BENCHMARK(second_start)->Unit(benchmark::kMillisecond)->UseRealTime();

void dome(benchmark::State& state) {
    const TableSky& sky = ready_sky();
    for (auto _ : state)
        benchmark::DoNotOptimize(sky.dome(static_cast<double>(state.range(1)) * m, static_cast<double>(state.range(0)) * deg));
}
BENCHMARK(dome)
    ->ArgNames({"sun", "eye_m"})
    ->Args({30, 0})
    ->Args({94, 0})
    ->Args({30, 400'000})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void fisheye(benchmark::State& state) {
    const TableSky& sky = ready_sky();
    const ColourWeights weights(WavelengthGrid::standard(), earth().sun.irradiance);
    const RgbConverter converter(RgbSpace::srgb, WhitePoint::d65);
    const SkyScene scene{.altitude = 2.0 * m, .sun_zenith = 45.0 * deg};
    const int side = static_cast<int>(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(sky_image(sky, earth().sun, scene, Fisheye{.width = side, .height = side}, weights, converter));
    state.SetItemsProcessed(state.iterations() * side * side);
}
BENCHMARK(fisheye)->ArgName("side")->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime();

void direction_of_a_ray(benchmark::State& state) {
    const TableSky& sky = ready_sky();
    double zenith = 0.1;
    for (auto _ : state) {
        zenith = zenith < 3.0 ? zenith + 0.0137 : 0.01;
        benchmark::DoNotOptimize(sky.radiance({2.0 * m, zenith, 45.0 * deg, 1.0}));
    }
}
BENCHMARK(direction_of_a_ray)->Unit(benchmark::kMicrosecond);

void direction_of_a_dome(benchmark::State& state) {
    const auto sky = *ready_sky().dome(2.0 * m, 45.0 * deg);
    std::vector<float> radiance(sixteen().size());
    double zenith = 0.1;
    for (auto _ : state) {
        zenith = zenith < 3.0 ? zenith + 0.0137 : 0.01;
        sky->radiance(zenith, 1.0, radiance);
        benchmark::DoNotOptimize(radiance.data());
    }
}
BENCHMARK(direction_of_a_dome)->Unit(benchmark::kNanosecond);

}  // namespace
