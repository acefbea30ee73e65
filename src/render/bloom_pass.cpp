#include "render/bloom_pass.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <utility>

#include "render/shaders.h"

namespace airlight::render {

namespace {

// The smallest picture of the pyramid is no smaller.
constexpr int smallest_side = 4;

int half(int side) { return (side + 1) / 2; }

}  // namespace

Result<BloomPass> BloomPass::create(int width, int height) {
    Result<gpu::Program> shrink = program("fullscreen.vert", "bloom_shrink.frag"), grow = program("fullscreen.vert", "bloom_grow.frag");
    if (!shrink) return shrink.error();
    if (!grow) return grow.error();
    std::vector<Level> levels;
    do {
        width = half(width), height = half(height);
        gpu::Texture light({width, height});
        Result<gpu::Framebuffer> target = gpu::Framebuffer::create({&light});
        if (!target) return target.error();
        levels.push_back({std::move(light), std::move(*target)});
    } while (std::min(width, height) >= 2 * smallest_side);
    return BloomPass(std::move(*shrink), std::move(*grow), std::move(levels));
}

BloomPass::BloomPass(gpu::Program shrink, gpu::Program grow, std::vector<Level> levels)
    : shrink_(std::move(shrink)), grow_(std::move(grow)), levels_(std::move(levels)) {}

void BloomPass::draw(const gpu::Texture& radiance) const {
    glDisable(GL_DEPTH_TEST);
    shrink_.use();
    const gpu::Texture* from = &radiance;
    for (const Level& level : levels_) {
        level.target.bind();
        from->bind_sampler(0);
        triangle_.draw_triangles(3);
        from = &level.light;
    }
    // Of the n levels from here to the smallest, this one keeps 1 / n of the light, the others have the rest.
    grow_.use();
    glEnable(GL_BLEND);
    glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
    for (std::size_t i = levels_.size() - 1; i-- > 0;) {
        const auto n = static_cast<float>(levels_.size() - i);
        glBlendColor(0.0f, 0.0f, 0.0f, (n - 1.0f) / n);
        levels_[i].target.bind();
        levels_[i + 1].light.bind_sampler(0);
        triangle_.draw_triangles(3);
    }
    glDisable(GL_BLEND);
}

}  // namespace airlight::render
