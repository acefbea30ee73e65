// Writing pictures of a sky, 1024 x 1024: the requirement is 0.3 s.

#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "image/exr.h"
#include "image/png.h"
#include "image/tone.h"

using namespace airlight;

namespace {

// A smooth sky with a little of Monte Carlo's noise.
Image sky(float noise) {
    Image image(1024, 1024, 3);
    unsigned state = 1;
    for (std::size_t i = 0; i < image.values.size(); ++i) {
        state = state * 1664525u + 1013904223u;
        const float brightness = 3000.0f + 2000.0f * std::sin(static_cast<float>(i / 3) * 1e-5f);
        image.values[i] = brightness * (1.0f + noise * static_cast<float>(state >> 8) / 16777216.0f);
    }
    return image;
}

const std::filesystem::path file = std::filesystem::temp_directory_path() / ("airlight-benchmark-" + std::to_string(::getpid()));

void write_exr_float(benchmark::State& state) {
    const Image image = sky(0.01f);
    for (auto _ : state) benchmark::DoNotOptimize(write_exr(file, image, ImageMeaning::rgb(RgbSpace::acescg)));
    std::filesystem::remove(file);
}
void write_exr_half(benchmark::State& state) {
    const Image image = sky(0.01f);
    for (auto _ : state) benchmark::DoNotOptimize(write_exr(file, image, ImageMeaning::rgb(RgbSpace::acescg), ExrPixels::float16));
    std::filesystem::remove(file);
}
void develop(benchmark::State& state) {
    const Image image = sky(0.01f);
    for (auto _ : state) benchmark::DoNotOptimize(developed(image, 1e-4, ToneCurve::filmic));
}
void write_png_eight(benchmark::State& state) {
    const Image image = developed(sky(0.01f), 1e-4, ToneCurve::filmic);
    for (auto _ : state) benchmark::DoNotOptimize(write_png(file, image));
    std::filesystem::remove(file);
}
void write_png_sixteen(benchmark::State& state) {
    const Image image = developed(sky(0.01f), 1e-4, ToneCurve::filmic);
    for (auto _ : state) benchmark::DoNotOptimize(write_png(file, image, PngBits::sixteen));
    std::filesystem::remove(file);
}

}  // namespace

BENCHMARK(write_exr_float)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(write_exr_half)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(develop)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(write_png_eight)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(write_png_sixteen)->Unit(benchmark::kMillisecond)->UseRealTime();
