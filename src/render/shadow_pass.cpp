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
    std::array<std::int32_t, 4> count;  // of cascades; texels of a map's side
};

Four four(Vec3 v, double w) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), static_cast<float>(w)}; }

// Which of the maps, one above the other: neighbouring levels have different ones.
int map_of(const Cascade& c) { return c.level % most_cascades; }

// Places relative to an eye.
Block block_of(std::span<const Cascade> cascades, const LightAxes& axes, Vec3 eye, double highest_m, int texels) {
    Block block{four(axes.right, 0.0), four(axes.up, 0.0), four(axes.towards_sun, highest_m), {}, {}, {}};
    const Vec3 from(glm::dot(eye, axes.right), glm::dot(eye, axes.up), glm::dot(eye, axes.towards_sun));
    for (std::size_t i = 0; i < cascades.size(); ++i) {
        const Cascade& c = cascades[i];
        block.place[i] = four(Vec3(c.centre.x, c.centre.y, c.lowest_m) - from, c.half_width_m);
        block.depth[i] = four({c.highest_m - c.lowest_m, c.texel_m, c.to_m}, map_of(c));
    }
    block.count = {static_cast<std::int32_t>(cascades.size()), texels, 0, 0};
    return block;
}

// Above the planet's sphere there is neither ground nor an object from here on.
double highest_m(const HeightField& field, std::span<const Ball> objects) {
    double highest = std::max(0.0, field.whole.high);
    for (const Ball& object : objects) highest = std::max(highest, glm::length(object.centre) + object.radius_m - field.radius_m);
    return highest;
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

void ShadowPass::draw(TerrainPass& terrain, const ObjectPass& objects, const Camera& camera, Vec3 towards_sun) {
    const HeightField& field = terrain.quadtree().field();
    axes_ = light_axes(settled_sun(towards_sun));
    cascades_ = render::cascades(camera, axes_, field, settings_.texels, objects.balls());
    patches_ = 0;
    for (const Cascade& cascade : cascades_) {
        std::optional<Drawn>& drawn = maps_of_[static_cast<std::size_t>(map_of(cascade))];
        if (const Drawn wanted{cascade, axes_.towards_sun}; drawn != wanted) {
            draw_map(terrain, objects, camera, cascade);
            drawn = wanted;
        }
    }
    const Block block = block_of(cascades_, axes_, camera.eye, highest_m(field, objects.balls()), settings_.texels);
    block_.write(std::as_bytes(std::span(&block, 1)));
    camera_.bind(camera);
}

void ShadowPass::draw_map(TerrainPass& terrain, const ObjectPass& objects, const Camera& camera, const Cascade& cascade) {
    Camera eye = camera;
    eye.eye = cascade.eye;
    camera_.bind(eye);
    const Block block = block_of(std::span(&cascade, 1), axes_, cascade.eye, 0.0, settings_.texels);
    block_.write(std::as_bytes(std::span(&block, 1)));
    block_.bind_uniform(block_binding);
    target_.bind();
    const GLint lowest = map_of(cascade) * settings_.texels;
    glViewport(0, lowest, settings_.texels, settings_.texels);
    glScissor(0, lowest, settings_.texels, settings_.texels);
    glEnable(GL_SCISSOR_TEST);
    glDepthMask(GL_TRUE);
    target_.clear_depth(0.0f);
    glDisable(GL_SCISSOR_TEST);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glEnable(GL_DEPTH_CLAMP);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(slope_bias, 0.0f);
    patches_ += terrain.draw_depths(cascade.eye, casters_of(cascade, axes_, terrain.quadtree().field()));
    objects.draw_depths();
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_DEPTH_CLAMP);
    glDisable(GL_DEPTH_TEST);
}

void ShadowPass::bind() const {
    block_.bind_uniform(block_binding);
    maps_.bind_sampler(map_binding);
}

}  // namespace airlight::render
