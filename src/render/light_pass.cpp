#include "render/light_pass.h"

#include <epoxy/gl.h>

#include <array>

#include "render/shaders.h"

namespace airlight::render {

namespace {

std::array<float, 4> four(Vec3 v, float w = 0.0f) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), w}; }

}  // namespace

Result<LightPass> LightPass::create() {
    Result<gpu::Program> made = program("fullscreen.vert", "light.frag");
    if (!made) return made.error();
    return LightPass(std::move(*made));
}

LightPass::LightPass(gpu::Program program)
    : program_(std::move(program)), lights_(12 * sizeof(float)), lit_({1, 1}, std::array{1.0f, 1.0f, 1.0f, 1.0f}) {}

void LightPass::draw(const GeometryBuffer& surfaces, const Lights& lights, const gpu::Texture* shade,
                     const gpu::Texture* background) const {
    const std::array<std::array<float, 4>, 3> block = {four(lights.towards_sun), four(lights.sun),
                                                       four(lights.sky, background ? 1.0f : 0.0f)};
    lights_.write(std::as_bytes(std::span(block)));
    lights_.bind_uniform(2);
    surfaces.depth().bind_sampler(0);
    surfaces.colour().bind_sampler(1);
    surfaces.normal().bind_sampler(2);
    surfaces.material().bind_sampler(3);
    (background ? *background : lit_).bind_sampler(4);
    (shade ? *shade : lit_).bind_sampler(7);
    program_.use();
    glDisable(GL_DEPTH_TEST);
    triangle_.draw_triangles(3);
}

}  // namespace airlight::render
