// What a direction of the fitted skies costs on one core, in batches: the bounds are 250 ns for sixteen bands of hosek2012 and
// 30 ns for preetham1999 in RGB. The time of a batch over its directions is the counter `direction`.

#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>

#include "atmosphere/presets.h"
#include "core/files.h"
#include "models/hosek2012_data.h"
#include "models/model.h"
#include "models/preetham1999_rgb.h"

using namespace airlight;

namespace {

constexpr std::size_t batch = 4096;

// Even over the upper hemisphere.
std::vector<Direction> directions() {
    std::vector<Direction> all;
    for (std::size_t i = 0; i < batch; ++i)
        all.push_back({std::acos((static_cast<double>(i) + 0.5) / batch), std::remainder(2.399963 * static_cast<double>(i), 2.0 * pi)});
    return all;
}

void report(benchmark::State& state) {
    state.counters["direction"] = benchmark::Counter(batch, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

// Any sky of a file's form costs the same, so the numbers do not matter: sixteen bands of the data, each asked for.
void hosek2012_sixteen_bands(benchmark::State& state) {
    Hosek2012Data data{{}, {0.0, 1.0}, {1.0, 10.0}, {}};
    for (int i = 0; i < 16; ++i) data.wavelengths_nm.push_back(360.0 + 24.0 * i);
    Hosek2012Points points;
    for (std::size_t c = 0; c < 10; ++c) points[c].fill(std::array{-1.0, -0.4, 0.5, 2.0, -3.0, 0.3, 0.01, 0.5, 0.7, 0.1}[c]);
    data.points.assign(16 * 4, points);
    const auto file = std::filesystem::temp_directory_path() / "airlight-hosek2012-benchmark.csv";
    if (!write_file(file, hosek2012_csv(data, "# of no sky"))) return state.SkipWithError("the temporary folder cannot be written");
    std::vector<Wavelength> wavelengths;
    for (const double w : data.wavelengths_nm) wavelengths.push_back(w * nm);
    const auto sky = make_sky("hosek2012", *preset("earth-clear"), wavelengths, {.turbidity = 3.0, .data = file});
    std::filesystem::remove(file);
    const auto dome = *(*sky)->dome(0.0 * m, 45.0 * deg);
    const std::vector<Direction> asked = directions();
    std::vector<float> radiance(batch * 16);
    for (auto _ : state) {
        dome->radiances(asked, radiance);
        benchmark::DoNotOptimize(radiance.data());
    }
    report(state);
}
BENCHMARK(hosek2012_sixteen_bands)->Unit(benchmark::kMicrosecond);

void preetham1999_in_rgb(benchmark::State& state) {
    const Preetham1999Rgb sky(2.53, 45.0 * deg);
    const std::vector<Direction> asked = directions();
    std::vector<float> rgb(batch * 3);
    for (auto _ : state) {
        sky.radiances(asked, rgb);
        benchmark::DoNotOptimize(rgb.data());
    }
    report(state);
}
BENCHMARK(preetham1999_in_rgb)->Unit(benchmark::kMicrosecond);

}  // namespace
