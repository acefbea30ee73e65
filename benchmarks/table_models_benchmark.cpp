// What the models of tables computed ahead cost: a direction, in a batch, at sixteen wavelengths, on one core.

#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>

#include "atmosphere/presets.h"
#include "models/model.h"
#include "spectrum/wavelength_grid.h"

using namespace airlight;

namespace {

std::vector<Wavelength> sixteen() {
    const WavelengthGrid grid = WavelengthGrid::standard();
    return {grid.begin(), grid.end()};
}

std::unique_ptr<Sky> sky_of(const char* key) {
    // The cost of a direction does not depend on how finely the source was baked.
    return std::move(*make_sky(
        key, *preset("earth-clear"), sixteen(),
        {.bake = {.sizes = {.transmittance_mu = 128, .transmittance_altitude = 64, .sun = 24, .azimuth = 8, .view = 16, .altitude = 12},
                  .orders = 2},
         .cache = {.enabled = false}}));
}

// Directions all over the sky, in no order.
std::vector<Direction> directions() {
    std::vector<Direction> all;
    for (int i = 0; i < 4096; ++i)
        all.push_back({std::acos(std::fmod(0.5 + 0.754877666 * i, 1.0)), 2.0 * pi * std::fmod(0.569840291 * i, 1.0)});
    return all;
}

void directions_of(benchmark::State& state, const char* key) {
    const std::unique_ptr<Sky> sky = sky_of(key);
    const std::unique_ptr<SkyDome> dome = std::move(*sky->dome(0.0 * m, 60.0 * deg));
    const std::vector<Direction> all = directions();
    std::vector<float> radiance(all.size() * sky->wavelengths().size());
    for (auto _ : state) {
        dome->radiances(all, radiance);
        benchmark::DoNotOptimize(radiance.data());
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(all.size()));
    state.counters["direction"] = benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(all.size()),
                                                     benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK_CAPTURE(directions_of, bruneton2008, "bruneton2008");
BENCHMARK_CAPTURE(directions_of, schafhitzel2007, "schafhitzel2007");
BENCHMARK_CAPTURE(directions_of, elek2009, "elek2009");
BENCHMARK_CAPTURE(directions_of, hillaire2020, "hillaire2020");

}  // namespace
