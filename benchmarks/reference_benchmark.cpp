// Paths a second of the Monte Carlo reference, on one core, each carrying sixteen wavelengths.

#include <benchmark/benchmark.h>

#include <cmath>

#include "core/parallel.h"
#include "transport/columns.h"
#include "transport/reference.h"

using namespace airlight;

namespace {

// Coefficients like those of clear air over land: Rayleigh's fourth power, an Ångström law, ozone's Chappuis band.
Atmosphere clear_earth(const std::vector<Wavelength>& wavelengths) {
    const auto spectrum = [&](auto coefficient) {
        std::vector<SpectrumOf<InverseLength>::Sample> samples;
        for (const Wavelength w : wavelengths) samples.push_back({w, coefficient(w.in(550.0 * nm)) * per_m});
        return *SpectrumOf<InverseLength>::of(samples);
    };
    Atmosphere a;
    a.name = "clear";
    a.bottom_radius = 6360.0 * km;
    a.top_altitude = 100.0 * km;
    a.constituents.push_back({"air", ExponentialProfile{8.0 * km}, spectrum([](double x) { return 1.22e-5 * std::pow(x, -4.08); }),
                              SpectrumOf<InverseLength>::constant(0.0 * per_m), RayleighPhase{}});
    a.constituents.push_back({"aerosol", ExponentialProfile{1.2 * km}, spectrum([](double x) { return 5.0e-5 * std::pow(x, -1.3); }),
                              spectrum([](double x) { return 4.0e-6 * std::pow(x, -1.3); }),
                              HenyeyGreensteinPhase{SpectrumOf<Number>::constant(0.76)}});
    a.constituents.push_back({"ozone", TriangleProfile{10.0 * km, 25.0 * km, 40.0 * km}, SpectrumOf<InverseLength>::constant(0.0 * per_m),
                              spectrum([](double x) { return 2.0e-6 * std::exp(-std::pow((x - 1.09) / 0.12, 2.0)); }), IsotropicPhase{}});
    a.ground_albedo = SpectrumOf<Number>::constant(0.1);
    return a;
}

std::vector<Wavelength> sixteen() {
    std::vector<Wavelength> result;
    for (int i = 0; i < 16; ++i) result.push_back((360.0 + (830.0 - 360.0) * i / 15.0) * nm);
    return result;
}

// The rate of all its work is items_per_second; arguments: sun and view zenith angle in degrees, altitude in km.
void reference_paths(benchmark::State& state) {
    const ThreadLimit one(1);
    const Reference reference = *Reference::of(clear_earth(sixteen()), sixteen());
    const View view{static_cast<double>(state.range(2)) * km, static_cast<double>(state.range(1)) * deg,
                    static_cast<double>(state.range(0)) * deg, 1.0};
    constexpr std::int64_t paths = 8192;
    double error = 0.0;
    std::uint64_t seed = 1;
    for (auto _ : state) {
        const RadianceEstimate estimate = *reference.radiance(view, {.paths = paths, .seed = seed++});
        error = estimate.standard_error[5] / estimate.radiance_W_m2_sr_nm[5];
        benchmark::DoNotOptimize(error);
    }
    state.SetItemsProcessed(state.iterations() * paths);
    // Relative standard error of one path at 517 nm: what remains of it after n paths is this over the root of n.
    state.counters["error_of_one_path"] = error * std::sqrt(static_cast<double>(paths));
}
BENCHMARK(reference_paths)
    ->ArgNames({"sun", "view", "km"})
    ->Args({45, 30, 0})
    ->Args({45, 75, 0})
    ->Args({88, 85, 0})
    ->Args({94, 60, 0})
    ->Args({60, 109, 400})
    ->Args({94, 109, 400})
    ->Unit(benchmark::kMillisecond);

void reference_setup(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(Reference::of(clear_earth(sixteen()), sixteen()));
}
BENCHMARK(reference_setup)->Unit(benchmark::kMillisecond);

void columns_to_top(benchmark::State& state) {
    const std::vector<DensityProfile> profiles = {ExponentialProfile{8.0 * km}, ExponentialProfile{1.2 * km},
                                                  TriangleProfile{10.0 * km, 25.0 * km, 40.0 * km}};
    const Columns columns(profiles, f64::Length::of(6.36e6), f64::Length::of(1e5));
    double x = 0.1;
    for (auto _ : state) {
        x = x < 0.9 ? x + 0.0137 : 0.01;
        benchmark::DoNotOptimize(columns.to_top(3e4 * x * x, x));
    }
}
BENCHMARK(columns_to_top);

}  // namespace
