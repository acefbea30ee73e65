#include "gpu/texture.h"

#include <epoxy/gl.h>

namespace airlight::gpu {

namespace {

unsigned create(TextureSize size) {
    GLuint name = 0;
    glCreateTextures(size.depth ? GL_TEXTURE_3D : GL_TEXTURE_2D, 1, &name);
    if (size.depth) glTextureStorage3D(name, 1, GL_RGBA32F, size.width, size.height, size.depth);
    else glTextureStorage2D(name, 1, GL_RGBA32F, size.width, size.height);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) glTextureParameteri(name, axis, GL_CLAMP_TO_EDGE);
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return name;
}

}  // namespace

void DeleteTexture::operator()(unsigned name) const { glDeleteTextures(1, &name); }

Texture::Texture(TextureSize size, std::span<const float> texels) : size_(size), handle_(create(size)) {
    if (texels.empty()) return;
    if (size.depth) glTextureSubImage3D(name(), 0, 0, 0, 0, size.width, size.height, size.depth, GL_RGBA, GL_FLOAT, texels.data());
    else glTextureSubImage2D(name(), 0, 0, 0, size.width, size.height, GL_RGBA, GL_FLOAT, texels.data());
}

void Texture::bind_sampler(unsigned binding) const { glBindTextureUnit(binding, name()); }

void Texture::bind_image(unsigned binding) const { glBindImageTexture(binding, name(), 0, GL_TRUE, 0, GL_READ_WRITE, GL_RGBA32F); }

void Texture::read(std::span<float> texels) const {
    glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
    glGetTextureImage(name(), 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(texels.size_bytes()), texels.data());
}

}  // namespace airlight::gpu
