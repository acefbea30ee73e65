// What the model `airlight` costs on one core, from ready tables: a ray, a dome, a direction of a dome, and a sky-view picture of
// 200 x 100 directions, its dome included. Air of the preset earth-clear at sixteen wavelengths.

#include <benchmark/benchmark.h>

#include <cmath>

#include "atmosphere/presets.h"
#include "core/parallel.h"
#include "models/model.h"
#include "spectrum/wavelength_grid.h"

using namespace airlight;

namespace {

const Sky& sky() {
    static const std::unique_ptr<Sky> made = [] {
        const WavelengthGrid grid = WavelengthGrid::standard();
        return *make_sky("airlight", *preset("earth-clear"), {grid.begin(), grid.end()});
    }();
    return *made;
}

void airlight_ray(benchmark::State& state) {
    sky();
    double zenith = 0.1;
    for (auto _ : state) {
        zenith = zenith < 3.0 ? zenith + 0.0137 : 0.01;
        benchmark::DoNotOptimize(sky().radiance({2.0 * m, zenith, 45.0 * deg, 1.0}));
    }
}
BENCHMARK(airlight_ray)->Unit(benchmark::kMicrosecond);

// By day, and with more rays where the edge of the planet's shadow may be seen.
void airlight_dome(benchmark::State& state) {
    sky();
    const ThreadLimit one(1);
    for (auto _ : state) benchmark::DoNotOptimize(sky().dome(2.0 * m, static_cast<double>(state.range(0)) * deg));
}
BENCHMARK(airlight_dome)->ArgName("sun")->Arg(45)->Arg(92)->Unit(benchmark::kMillisecond);

void airlight_sky_view(benchmark::State& state) {
    constexpr int width = 200, height = 100;
    sky();
    const ThreadLimit one(1);
    // Rows crowd towards the horizon, as in a sky-view table.
    std::vector<Direction> directions;
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            const double y = 2.0 * (j + 0.5) / height - 1.0;
            directions.push_back({0.5 * pi * (1.0 + std::copysign(y * y, y)), 2.0 * pi * (i + 0.5) / width});
        }
    std::vector<float> radiance(directions.size() * sky().wavelengths().size());
    for (auto _ : state) {
        const auto dome = *sky().dome(2.0 * m, 45.0 * deg);
        dome->radiances(directions, radiance);
        benchmark::DoNotOptimize(radiance.data());
    }
    state.SetItemsProcessed(state.iterations() * width * height);
}
BENCHMARK(airlight_sky_view)->Unit(benchmark::kMillisecond);

}  // namespace
