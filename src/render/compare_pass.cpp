#include "render/compare_pass.h"

#include <epoxy/gl.h>

#include <cstdint>
#include <utility>

#include "render/rgb_block.h"
#include "render/shaders.h"

namespace airlight::render {

namespace {

// std140: `uniform Comparing` of compare.frag.
struct Settings {
    std::array<float, 4> luminance_of_rgb;
    std::int32_t difference;
    float edge, span, unused;
};
static_assert(sizeof(Settings) == 32);

}  // namespace

Result<ComparePass> ComparePass::create() {
    Result<gpu::Program> made = program("fullscreen.vert", "compare.frag");
    if (!made) return made.error();
    return ComparePass(std::move(*made));
}

ComparePass::ComparePass(gpu::Program program) : program_(std::move(program)), settings_(sizeof(Settings)) {}

void ComparePass::side_by_side(const gpu::Texture& first, const gpu::Texture& second, double edge) const {
    draw(first, second, false, edge, 1.0);
}

void ComparePass::difference(const gpu::Texture& first, const gpu::Texture& second, double span) const {
    draw(first, second, true, 0.0, span);
}

void ComparePass::draw(const gpu::Texture& first, const gpu::Texture& second, bool difference, double edge, double span) const {
    const Settings settings{luminance_of_rgb(), difference ? 1 : 0, static_cast<float>(edge), static_cast<float>(span), 0.0f};
    settings_.write(std::as_bytes(std::span(&settings, 1)));
    settings_.bind_uniform(1);
    first.bind_sampler(0);
    second.bind_sampler(1);
    program_.use();
    glDisable(GL_DEPTH_TEST);
    triangle_.draw_triangles(3);
}

}  // namespace airlight::render
