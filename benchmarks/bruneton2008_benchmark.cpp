// How long the GPU takes to fill the tables of bruneton2008, four orders, and each of its passes, by the GPU's clock:
// for one group of wavelengths (three) and for four (sixteen).

#include <benchmark/benchmark.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "atmosphere/presets.h"
#include "gpu/context.h"
#include "render/bruneton2008_tables.h"
#include "spectrum/wavelength_grid.h"

using namespace airlight;

namespace {

void tables(benchmark::State& state) {
    const Result<gpu::Context> context = gpu::Context::create();
    if (!context) return state.SkipWithError(context.error().message().c_str());
    const Result<std::shared_ptr<const render::Bruneton2008Programs>> programs = render::bruneton2008_programs();
    if (!programs) return state.SkipWithError(programs.error().message().c_str());
    const WavelengthGrid grid = WavelengthGrid::standard();
    std::vector<Wavelength> wavelengths(grid.begin(), grid.end());
    if (state.range(0) == 3) wavelengths = {440.0 * nm, 550.0 * nm, 680.0 * nm};
    const Atmosphere atmosphere = *preset("earth-clear");
    std::map<std::string, double> passes;
    for ([[maybe_unused]] auto _ : state) {
        render::Bruneton2008Bake bake(*programs, atmosphere, wavelengths, render::fine_texels,
                                      {.sizes = render::sizes_around_points, .orders = 4});
        gpu::PassTimers timers;
        while (bake.done() < bake.slices()) bake.advance(timers);
        for (const gpu::PassTime& time : timers.read()) passes[time.pass] += time.milliseconds;
    }
    for (const auto& [pass, milliseconds] : passes)
        state.counters[pass + ", ms"] = benchmark::Counter(milliseconds, benchmark::Counter::kAvgIterations);
    state.SetLabel(context->renderer());
}

}  // namespace

BENCHMARK(tables)->ArgName("wavelengths")->Arg(3)->Arg(16)->Unit(benchmark::kMillisecond)->UseRealTime();
