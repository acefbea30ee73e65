#include "render/geometry_buffer.h"

#include <epoxy/gl.h>

#include <utility>

namespace airlight::render {

Result<GeometryBuffer> GeometryBuffer::create(int width, int height) {
    using F = gpu::TextureFormat;
    const gpu::TextureSize size{width, height};
    gpu::Texture depth(size, {}, F::depth32f), colour(size, {}, F::srgb8), normal(size, {}, F::rg16), material(size, {}, F::rg16);
    Result<gpu::Framebuffer> target = gpu::Framebuffer::create({&colour, &normal, &material}, &depth);
    if (!target) return target.error();
    return GeometryBuffer(std::move(depth), std::move(colour), std::move(normal), std::move(material), std::move(*target));
}

GeometryBuffer::GeometryBuffer(gpu::Texture depth, gpu::Texture colour, gpu::Texture normal, gpu::Texture material, gpu::Framebuffer target)
    : depth_(std::move(depth)),
      colour_(std::move(colour)),
      normal_(std::move(normal)),
      material_(std::move(material)),
      target_(std::move(target)) {}

void GeometryBuffer::begin() const {
    target_.bind();
    for (unsigned i = 0; i < 3; ++i) target_.clear_colour(i, 0.0f, 0.0f, 0.0f, 0.0f);
    glDepthMask(GL_TRUE);
    target_.clear_depth(0.0f);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glEnable(GL_FRAMEBUFFER_SRGB);
}

void GeometryBuffer::end() { glDisable(GL_DEPTH_TEST); }

}  // namespace airlight::render
