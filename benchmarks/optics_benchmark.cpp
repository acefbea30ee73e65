// How long an aerosol takes at 16 wavelengths (the bound is 2 s on two cores), and a sphere's series.

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "optics/aerosol.h"
#include "optics/mie.h"

using namespace airlight;

namespace {

void aerosol_at_16_wavelengths(benchmark::State& state) {
    const AerosolType type = aerosol_types[static_cast<std::size_t>(state.range(0))];
    std::vector<Wavelength> wavelengths;
    for (int i = 0; i < 16; ++i) wavelengths.push_back((360.0 + 470.0 * i / 15.0) * nm);
    for (auto _ : state) benchmark::DoNotOptimize(aerosol_optics(type, 80.0, wavelengths));
    state.SetLabel(std::string(name(type)));
}
BENCHMARK(aerosol_at_16_wavelengths)->DenseRange(0, 6)->Unit(benchmark::kMillisecond)->UseRealTime();

void efficiencies_of_a_sphere(benchmark::State& state) {
    const double x = static_cast<double>(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(mie_efficiencies(x, {1.5, 0.01}));
}
BENCHMARK(efficiencies_of_a_sphere)->RangeMultiplier(10)->Range(1, 10000)->Unit(benchmark::kMicrosecond);

}  // namespace
