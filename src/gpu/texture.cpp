#include "gpu/texture.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <bit>

namespace airlight::gpu {

namespace {

struct Layout {
    GLenum stored;    // GL_RGBA32F
    GLenum channels;  // GL_RGBA
    int count;
};

Layout layout_of(TextureFormat format) {
    switch (format) {
        case TextureFormat::rgba32f:
            return {GL_RGBA32F, GL_RGBA, 4};
        case TextureFormat::rgba16f:
            return {GL_RGBA16F, GL_RGBA, 4};
        case TextureFormat::rgba8:
            return {GL_RGBA8, GL_RGBA, 4};
        case TextureFormat::srgb8:
            return {GL_SRGB8_ALPHA8, GL_RGBA, 4};
        case TextureFormat::rg8:
            return {GL_RG8, GL_RG, 2};
        case TextureFormat::rg16:
            return {GL_RG16, GL_RG, 2};
        case TextureFormat::r32f:
            return {GL_R32F, GL_RED, 1};
        case TextureFormat::depth32f:
            return {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, 1};
        case TextureFormat::depth24:
            return {GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, 1};
    }
    return {};
}

unsigned create(TextureSize size, GLenum stored, int levels = 1) {
    GLuint name = 0;
    glCreateTextures(size.depth ? GL_TEXTURE_3D : GL_TEXTURE_2D, 1, &name);
    if (size.depth) glTextureStorage3D(name, levels, stored, size.width, size.height, size.depth);
    else glTextureStorage2D(name, levels, stored, size.width, size.height);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) glTextureParameteri(name, axis, GL_CLAMP_TO_EDGE);
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return name;
}

}  // namespace

int channels(TextureFormat format) { return layout_of(format).count; }

void DeleteTexture::operator()(unsigned name) const { glDeleteTextures(1, &name); }

Texture::Texture(TextureSize size, std::span<const float> texels, TextureFormat format)
    : size_(size), format_(format), handle_(create(size, layout_of(format).stored)) {
    if (texels.empty()) return;
    const GLenum layout = layout_of(format).channels;
    if (size.depth) glTextureSubImage3D(name(), 0, 0, 0, 0, size.width, size.height, size.depth, layout, GL_FLOAT, texels.data());
    else glTextureSubImage2D(name(), 0, 0, 0, size.width, size.height, layout, GL_FLOAT, texels.data());
}

Texture Texture::around_a_sphere(TextureSize size, std::span<const std::uint8_t> levels) {
    const int smaller = std::bit_width(static_cast<unsigned>(std::max(size.width, size.height)));
    Texture texture(size, TextureFormat::srgb8, create(size, GL_SRGB8_ALPHA8, smaller));
    glTextureSubImage2D(texture.name(), 0, 0, 0, size.width, size.height, GL_RGBA, GL_UNSIGNED_BYTE, levels.data());
    glGenerateTextureMipmap(texture.name());
    glTextureParameteri(texture.name(), GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTextureParameteri(texture.name(), GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    return texture;
}

void Texture::bind_sampler(unsigned binding) const { glBindTextureUnit(binding, name()); }

void Texture::bind_image(unsigned binding) const {
    glBindImageTexture(binding, name(), 0, GL_TRUE, 0, GL_READ_WRITE, layout_of(format_).stored);
}

void Texture::read(std::span<float> texels) const {
    glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
    glGetTextureImage(name(), 0, layout_of(format_).channels, GL_FLOAT, static_cast<GLsizei>(texels.size_bytes()), texels.data());
}

}  // namespace airlight::gpu
