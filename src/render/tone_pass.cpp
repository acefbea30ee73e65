#include "render/tone_pass.h"

#include <epoxy/gl.h>

#include <cstdint>
#include <utility>

#include "render/rgb_block.h"
#include "render/shaders.h"

namespace airlight::render {

namespace {

// std140: `uniform ToneSettings` of tone.frag.
struct Settings {
    std::array<float, 4> luminance_of_rgb;
    std::int32_t curve;
    float bloom;
    float unused[2];
};
static_assert(sizeof(Settings) == 32);

}  // namespace

Result<TonePass> TonePass::create() {
    Result<gpu::Program> made = program("fullscreen.vert", "tone.frag");
    if (!made) return made.error();
    return TonePass(std::move(*made));
}

TonePass::TonePass(gpu::Program program) : program_(std::move(program)), settings_(sizeof(Settings)) {}

void TonePass::draw(const gpu::Texture& radiance, const gpu::Buffer& exposure, ToneCurve curve) const {
    draw_with(radiance, radiance, exposure, curve, 0.0);
}

void TonePass::draw(const gpu::Texture& radiance, const gpu::Buffer& exposure, ToneCurve curve, const BloomPass& spread,
                    double bloom) const {
    draw_with(radiance, spread.spread(), exposure, curve, bloom);
}

void TonePass::draw_with(const gpu::Texture& radiance, const gpu::Texture& spread, const gpu::Buffer& exposure, ToneCurve curve,
                         double bloom) const {
    const Settings settings{luminance_of_rgb(), static_cast<std::int32_t>(curve), static_cast<float>(bloom), {}};
    settings_.write(std::as_bytes(std::span(&settings, 1)));
    settings_.bind_uniform(1);
    exposure.bind_storage(1);
    radiance.bind_sampler(0);
    spread.bind_sampler(1);
    program_.use();
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_FRAMEBUFFER_SRGB);
    triangle_.draw_triangles(3);
}

}  // namespace airlight::render
