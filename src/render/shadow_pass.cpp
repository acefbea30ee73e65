#include "render/shadow_pass.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <utility>

namespace airlight::render {

namespace {

using Four = std::array<float, 4>;

constexpr unsigned block_binding = 7, map_binding = 6;

// `uniform ShadowBlock` of src/render/shaders/shadow.glsl.
struct Block {
    Four right, up, towards_sun;
    std::array<Four, most_cascades> place, depth;
    std::array<std::int32_t, 4> count;  // of cascades; which is drawn; texels of a map's side
};

Four four(Vec3 v, double w) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), static_cast<float>(w)}; }

Block block_of(const std::vector<Cascade>& cascades, const LightAxes& axes, double highest_m, int texels) {
    Block block{four(axes.right, 0.0), four(axes.up, 0.0), four(axes.towards_sun, highest_m), {}, {}, {}};
    for (std::size_t i = 0; i < cascades.size(); ++i) {
        const Cascade& c = cascades[i];
        block.place[i] = four({c.centre.x, c.centre.y, c.lowest_m}, c.half_width_m);
        block.depth[i] = four({c.highest_m - c.lowest_m, c.texel_m, c.to_m}, 0.0);
    }
    block.count = {static_cast<std::int32_t>(cascades.size()), 0, texels, 0};
    return block;
}

// How much farther from the sun a triangle is drawn, in units of how much farther it gets within a texel: the filter of shadow.glsl reaches
// two texels along each axis, and a slope's larger part is at least half of it.
constexpr float slope_bias = -4.0f;

}  // namespace

Result<ShadowPass> ShadowPass::create(ShadowSettings settings) {
    gpu::Texture maps({settings.texels, most_cascades * settings.texels}, {}, gpu::TextureFormat::depth32f);
    Result<gpu::Framebuffer> target = gpu::Framebuffer::create({}, &maps);
    if (!target) return target.error();
    return ShadowPass(settings, std::move(maps), std::move(*target));
}

ShadowPass::ShadowPass(ShadowSettings settings, gpu::Texture maps, gpu::Framebuffer target)
    : settings_(settings), maps_(std::move(maps)), target_(std::move(target)), block_(sizeof(Block)) {}

void ShadowPass::draw(TerrainPass& terrain, const Camera& camera, Vec3 towards_sun) {
    const LightAxes axes = light_axes(towards_sun);
    const HeightField& field = terrain.quadtree().field();
    cascades_ = render::cascades(camera, axes, field, settings_.texels);
    patches_ = 0;
    Block block = block_of(cascades_, axes, std::max(0.0, field.whole.high), settings_.texels);
    block_.bind_uniform(block_binding);
    target_.bind();
    glDepthMask(GL_TRUE);
    target_.clear_depth(0.0f);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glEnable(GL_DEPTH_CLAMP);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(slope_bias, 0.0f);
    for (std::size_t i = 0; i < cascades_.size(); ++i) {
        block.count[1] = static_cast<std::int32_t>(i);
        block_.write(std::as_bytes(std::span(&block, 1)));
        glViewport(0, static_cast<GLint>(i) * settings_.texels, settings_.texels, settings_.texels);
        patches_ += terrain.draw_depths(camera.eye, casters_within(cascades_[i], camera, axes), finest_level(cascades_[i], field.radius_m));
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_DEPTH_CLAMP);
    glDisable(GL_DEPTH_TEST);
}

void ShadowPass::bind() const {
    block_.bind_uniform(block_binding);
    maps_.bind_sampler(map_binding);
}

}  // namespace airlight::render
