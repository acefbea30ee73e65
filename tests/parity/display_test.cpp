// From light to a display's levels on the GPU: exposure by a histogram, bloom, tone curves, gamut, encoding and dither, beside the CPU's.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "image/adaptation.h"
#include "image/exposure.h"
#include "image/png.h"
#include "image/tone.h"
#include "render/bloom_pass.h"
#include "render/compare_pass.h"
#include "render/exposure_pass.h"
#include "render/tone_pass.h"
#include "spectrum/colour.h"
#include "tools/gpu_case.h"
#include "tools/temporary_folder.h"

using namespace airlight;
using namespace airlight::test;

namespace {

constexpr double at_once = std::numeric_limits<double>::infinity();
// Half a bin of a twelfth of a stop, and float's rounding.
const double half_a_bin = std::exp2(1.0 / 24.0) * (1.0 + 1e-5);

// Rows of an image go downward, those of a texture upward.
gpu::Texture texture_of(const Image& image) {
    std::vector<float> texels;
    for (int row = image.height - 1; row >= 0; --row)
        for (int column = 0; column < image.width; ++column) {
            const std::span<const float> rgb = image.pixel(column, row);
            texels.insert(texels.end(), {rgb[0], rgb[1], rgb[2], 1.0f});
        }
    return gpu::Texture({image.width, image.height}, texels);
}

// Skies from twilight to noon, with colours beyond sRGB, black pixels and a sun.
Image skies(int width, int height) {
    Image image(width, height, 3);
    std::mt19937 random(7);
    std::uniform_real_distribution<float> stops(-3.0f, 14.0f), amount(-0.1f, 1.0f);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            for (float& value : image.pixel(column, row)) value = std::exp2(stops(random)) * amount(random);
    for (const int black : {0, 17, 90}) std::fill_n(image.pixel(black % width, black / width).begin(), 3, 0.0f);
    std::fill_n(image.pixel(5, 5).begin(), 3, 1.6e9f);
    return image;
}

std::vector<float> luminances(const Image& image) {
    const RgbConverter converter(RgbSpace::srgb, WhitePoint::d65);
    std::vector<float> all;
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < image.width; ++column) {
            const std::span<const float> rgb = image.pixel(column, row);
            all.push_back(static_cast<float>(std::max(0.0, converter.luminance({rgb[0], rgb[1], rgb[2]}))));
        }
    return all;
}

render::ExposurePass exposure_pass() {
    Result<render::ExposurePass> made = render::ExposurePass::create();
    if (!made) FAIL(made.error().message());
    return std::move(*made);
}

render::TonePass tone_pass() {
    Result<render::TonePass> made = render::TonePass::create();
    if (!made) FAIL(made.error().message());
    return std::move(*made);
}

// What a display of 8 bits shows, [height][width][3] from 0 to 255, the highest row first.
std::vector<int> shown(const Image& image, double exposure, ToneCurve curve) {
    const render::ExposurePass exposed = exposure_pass();
    exposed.set(exposure);
    const gpu::Texture light = texture_of(image), levels({image.width, image.height}, {}, gpu::TextureFormat::rgba8);
    const Result<gpu::Framebuffer> target = gpu::Framebuffer::create({&levels});
    REQUIRE(target);
    target->bind();
    tone_pass().draw(light, exposed.exposure(), curve);
    std::vector<float> read(static_cast<std::size_t>(4 * image.width * image.height));
    levels.read(read);
    std::vector<int> values;
    for (int row = image.height - 1; row >= 0; --row)
        for (int i = 0; i < 4 * image.width; ++i)
            if (i % 4 < 3)
                values.push_back(static_cast<int>(std::lround(255.0f * read[static_cast<std::size_t>(4 * row * image.width + i)])));
    return values;
}

double sum_of_red(const std::vector<float>& texels) {
    double sum = 0.0;
    for (std::size_t i = 0; i < texels.size(); i += 4) sum += static_cast<double>(texels[i]);
    return sum;
}

// The red of a pass of bloom over a picture, in light of the picture's pixels.
std::vector<float> spread_of(const Image& image) {
    const Result<render::BloomPass> bloom = render::BloomPass::create(image.width, image.height);
    if (!bloom) FAIL(bloom.error().message());
    bloom->draw(texture_of(image));
    std::vector<float> texels(static_cast<std::size_t>(4 * bloom->spread().size().width * bloom->spread().size().height));
    bloom->spread().read(texels);
    return texels;
}

}  // namespace

TEST_CASE("the histogram meters what image/exposure meters, within half a bin") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const render::ExposurePass exposure = exposure_pass();
    for (const auto& [width, height] : {std::pair{64, 48}, {33, 7}}) {
        const Image image = skies(width, height);
        const gpu::Texture texture = texture_of(image);
        for (const Metering& metering :
             {Metering{}, Metering{.darkest = 1e6}, Metering{.method = Metering::Method::percentile, .darkest = 1e6},
              Metering{.grey = 0.25}, Metering{.sun_disk = 1e10}, Metering{.method = Metering::Method::percentile},
              Metering{.method = Metering::Method::percentile, .share = 0.5}}) {
            exposure.meter(texture, metering, {}, at_once);
            const double ratio = exposure.read() / *metered_exposure(luminances(image), {}, metering);
            CAPTURE(ratio);
            CHECK(ratio <= half_a_bin);
            CHECK(ratio >= 1.0 / half_a_bin);
        }
    }
}

TEST_CASE("the exposure on the GPU follows the light as image/adaptation says, both ways, at any rate of frames") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    Image plain(16, 16, 3);
    std::fill(plain.values.begin(), plain.values.end(), 100.0f);
    const gpu::Texture light = texture_of(plain);
    const render::ExposurePass exposure = exposure_pass();
    exposure.meter(light, {}, {}, at_once);
    const double metered = exposure.read();
    const Adaptation adaptation{.to_brighter_s = 0.5, .to_darker_s = 2.0};
    for (const double before : {metered / 30.0, metered * 30.0})
        for (const int frames : {1, 7, 60}) {
            exposure.set(before);
            for (int frame = 0; frame < frames; ++frame) exposure.meter(light, {}, adaptation, 1.0 / frames);
            CHECK(exposure.read() == doctest::Approx(adapted_exposure(before, metered, 1.0, adaptation)).epsilon(2e-5));
        }
}

TEST_CASE("a picture without light leaves the exposure as it was") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const render::ExposurePass exposure = exposure_pass();
    exposure.set(0.125);
    for (const auto method : {Metering::Method::log_average, Metering::Method::percentile}) {
        exposure.meter(texture_of(Image(8, 8, 3)), {.method = method}, {}, at_once);
        CHECK(exposure.read() == 0.125);
    }
}

// Levels are equal but where float's rounding crosses a threshold: a level's 255 steps of 1e-6 or so.
TEST_CASE("a display shows the levels of a PNG file, for every curve and for colours beyond sRGB") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const TemporaryFolder folder;
    const RgbConverter converter(RgbSpace::srgb, WhitePoint::d65);
    const Image image = skies(96, 61);
    Image within = image;
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < image.width; ++column) {
            const std::span<float> rgb = within.pixel(column, row);
            const Rgb inside = converter.into_gamut({rgb[0], rgb[1], rgb[2]});
            rgb[0] = static_cast<float>(inside.r), rgb[1] = static_cast<float>(inside.g), rgb[2] = static_cast<float>(inside.b);
        }
    for (const ToneCurve curve : {ToneCurve::linear, ToneCurve::exponential, ToneCurve::reinhard, ToneCurve::filmic}) {
        CAPTURE(name_of(curve));
        const double exposure = 1.0 / 500.0;
        REQUIRE(write_png(folder.path / "cpu.png", developed(within, exposure, curve)));
        const Result<PngLevels> file = read_png(folder.path / "cpu.png");
        REQUIRE(file);
        const std::vector<int> gpu = shown(image, exposure, curve);
        int different = 0, farthest = 0;
        for (std::size_t i = 0; i < gpu.size(); ++i) {
            const int difference = std::abs(gpu[i] - file->levels[i]);
            different += difference > 0, farthest = std::max(farthest, difference);
        }
        fmt::print("  {:<12} {} of {} levels differ, by {}\n", name_of(curve), different, gpu.size(), farthest);
        CHECK(farthest <= 1);
        CHECK(different <= static_cast<int>(gpu.size()) / 500);
    }
}

// A ramp of two levels over the picture: rounding alone would show three flat bands, up to half a level off.
TEST_CASE("dither: the mean level of every patch of a smooth ramp is the ramp's") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    constexpr int side = 16, width = 16 * side;
    Image ramp(width, side, 3);
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < width; ++column)
            std::fill_n(ramp.pixel(column, row).begin(), 3,
                        static_cast<float>(srgb_linear((100.0 + 2.0 * (column + 0.5) / width) / 255.0)));
    const std::vector<int> levels = shown(ramp, 1.0, ToneCurve::linear);
    for (std::size_t patch = 0; patch < width / side; ++patch)
        for (std::size_t channel = 0; channel < 3; ++channel) {
            double sum = 0.0;
            for (std::size_t i = 0; i < side * side; ++i) sum += levels[3 * (i / side * width + patch * side + i % side) + channel];
            const double expected = 100.0 + 2.0 * (static_cast<double>(patch) + 0.5) * side / width;
            CHECK(std::abs(sum / (side * side) - expected) <= 0.02);  // as of PNG files: docs/theory.md, section 9
        }
}

TEST_CASE("bloom leaves an even picture even, of any size") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    for (const auto& [width, height] : {std::pair{64, 64}, {61, 35}, {3, 2}}) {
        Image even(width, height, 3);
        std::fill(even.values.begin(), even.values.end(), 1234.5f);
        for (const float value : spread_of(even)) CHECK(((value == doctest::Approx(1234.5f).epsilon(1e-6)) || value == 1.0f));
    }
}

// The pyramid's last step spreads over 2^5 pixels each way here: no edge is near.
TEST_CASE("bloom moves light, and neither adds nor loses any, and it falls with the square of the distance") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    constexpr int side = 256;
    Image star(side, side, 3);
    star.pixel(127, 130)[0] = 1e9f;
    const std::vector<float> spread = spread_of(star);
    // A texel is four pixels.
    CHECK(4.0 * sum_of_red(spread) == doctest::Approx(1e9).epsilon(1e-5));
    const auto at = [&](int distance) {
        return static_cast<double>(spread[static_cast<std::size_t>(4 * (125 / 2 * (side / 2) + 63 + distance / 2))]);
    };
    for (const int distance : {8, 16}) {
        const double fall = at(distance) / at(2 * distance);
        CAPTURE(fall);
        CHECK(fall > 2.5);
        CHECK(fall < 6.5);
    }
}

TEST_CASE("a picture shown with bloom is a blend of itself and its spread light") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    Image half_lit(64, 64, 3);
    for (int row = 0; row < 64; ++row)
        for (int column = 32; column < 64; ++column) std::fill_n(half_lit.pixel(column, row).begin(), 3, 1.0f);
    const render::ExposurePass exposed = exposure_pass();
    exposed.set(1.0);
    const Result<render::BloomPass> bloom = render::BloomPass::create(64, 64);
    REQUIRE(bloom);
    const gpu::Texture light = texture_of(half_lit), levels({64, 64}, {}, gpu::TextureFormat::rgba8);
    bloom->draw(light);
    const Result<gpu::Framebuffer> target = gpu::Framebuffer::create({&levels});
    REQUIRE(target);
    target->bind();
    tone_pass().draw(light, exposed.exposure(), ToneCurve::linear, *bloom, 0.2);
    std::vector<float> read(4 * 64 * 64);
    levels.read(read);
    const auto linear = [&](int column) {
        return srgb_linear(static_cast<double>(read[static_cast<std::size_t>(4 * (32 * 64 + column))]));
    };
    // Far from the edge nearly nothing changes; beside it the dark side has just below, the bright side just above a half of the share.
    CHECK(linear(31) > 0.07);
    CHECK(linear(31) < 0.1);
    CHECK(linear(32) > 0.9);
    CHECK(linear(32) < 0.93);
    CHECK(linear(0) < linear(31));
    CHECK(linear(63) > linear(32));
}

TEST_CASE("two pictures stand side by side at their edge, their difference is white where there is none, red and blue at its span") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    Image first(8, 2, 3), second(8, 2, 3);
    const std::array<float, 8> factor = {1.0f, 1.05f, 1.1f, 7.0f, 0.9f, 0.5f, 1.0f, 1.0f};
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 8; ++column) {
            std::fill_n(first.pixel(column, row).begin(), 3, column == 7 ? 0.0f : 1000.0f);
            std::fill_n(second.pixel(column, row).begin(), 3, factor[static_cast<std::size_t>(column)] * first.pixel(column, row)[0]);
        }
    const gpu::Texture a = texture_of(first), b = texture_of(second), compared({8, 2});
    const Result<gpu::Framebuffer> target = gpu::Framebuffer::create({&compared});
    REQUIRE(target);
    target->bind();
    const Result<render::ComparePass> pass = render::ComparePass::create();
    if (!pass) FAIL(pass.error().message());
    std::vector<float> read(4 * 8 * 2);
    pass->side_by_side(a, b, 0.5);
    compared.read(read);
    for (std::size_t column = 0; column < 8; ++column)
        CHECK(read[4 * column] == (column < 4 ? first : second).pixel(static_cast<int>(column), 1)[0]);
    pass->difference(a, b, 0.1);
    compared.read(read);
    const auto red = [&](std::size_t column) { return read[4 * column]; };
    const auto blue = [&](std::size_t column) { return read[4 * column + 2]; };
    for (const std::size_t same : {0, 6, 7}) CHECK(((red(same) == 1.0f) && blue(same) == 1.0f));
    CHECK(blue(1) == doctest::Approx(0.5 * (1.0 + blue(2))).epsilon(1e-4));
    CHECK(blue(2) == doctest::Approx(0.05).epsilon(1e-4));
    CHECK(blue(3) == blue(2));
    CHECK(red(4) == doctest::Approx(0.05).epsilon(1e-4));
    CHECK(red(5) == doctest::Approx(0.05).epsilon(1e-4));
}
