#include "render/exposure_pass.h"

#include <array>
#include <utility>

#include "render/rgb_block.h"
#include "render/shaders.h"

namespace airlight::render {

namespace {

constexpr unsigned histogram_binding = 0, exposure_binding = 1, settings_binding = 1;
constexpr unsigned group_side = 64;  // of the pixels that a group counts
constexpr std::size_t bins = 512;

// std140: `uniform Metering` of histogram.glsl.
struct Settings {
    std::array<float, 4> luminance_of_rgb, adapting;
    float grey, white_share, sun_disk, darkest;
};
static_assert(sizeof(Settings) == 48);

unsigned groups(int pixels) { return (static_cast<unsigned>(pixels) + group_side - 1) / group_side; }

}  // namespace

Result<ExposurePass> ExposurePass::create() {
    Result<gpu::Program> count = compute_program("histogram.comp"), follow = compute_program("exposure.comp");
    if (!count) return count.error();
    if (!follow) return follow.error();
    return ExposurePass(std::move(*count), std::move(*follow));
}

ExposurePass::ExposurePass(gpu::Program count, gpu::Program follow)
    : count_(std::move(count)),
      follow_(std::move(follow)),
      histogram_(bins * sizeof(unsigned)),
      settings_(sizeof(Settings)),
      exposure_(2 * sizeof(float)) {}

void ExposurePass::meter(const gpu::Texture& radiance, const Metering& metering, const Adaptation& adaptation, double seconds) const {
    const auto f = [](double x) { return static_cast<float>(x); };
    const bool percentile = metering.method == Metering::Method::percentile;
    const Settings settings{
        luminance_of_rgb(),
        {f(covered_share(seconds, adaptation.to_brighter_s)), f(covered_share(seconds, adaptation.to_darker_s)), 0.0f, 0.0f},
        f(metering.grey),
        percentile ? f(metering.share) : 0.0f,
        f(metering.sun_disk),
        f(metering.darkest)};
    settings_.write(std::as_bytes(std::span(&settings, 1)));
    settings_.bind_uniform(settings_binding);
    histogram_.bind_storage(histogram_binding);
    exposure_.bind_storage(exposure_binding);
    radiance.bind_sampler(0);
    count_.dispatch(groups(radiance.size().width), groups(radiance.size().height));
    follow_.dispatch(1);
}

void ExposurePass::set(double exposure) const {
    const auto value = static_cast<float>(exposure);
    exposure_.write(std::as_bytes(std::span(&value, 1)));
}

double ExposurePass::read() const {
    float value = 0.0f;
    exposure_.read(std::as_writable_bytes(std::span(&value, 1)));
    return static_cast<double>(value);
}

}  // namespace airlight::render
