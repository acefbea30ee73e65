// Texels on the GPU, two- or three-dimensional, read with linear filtering and clamped edges unless a Sampler says otherwise.
// Uses core; knows no physics.
#pragma once

#include <cstdint>
#include <span>

#include "gpu/handle.h"

namespace airlight::gpu {

struct DeleteTexture {
    void operator()(unsigned name) const;
};

// Texels across, down and deep; depth 0 is a two-dimensional texture.
struct TextureSize {
    int width = 1;
    int height = 1;
    int depth = 0;
};

// What a texel holds. Values in [0, 1] are stored in 8 or 16 bits. srgb8 holds values encoded with sRGB's transfer function, as which
// they are given here and read back; shaders read, and passes draw, linear ones.
enum class TextureFormat { rgba32f, rgba16f, rgba8, srgb8, rg8, rg16, r32f, depth32f, depth24 };
int channels(TextureFormat format);

class Texture {
public:
    // `texels` has channels(format) floats for each texel, width fastest, then height; empty leaves the texture undefined.
    explicit Texture(TextureSize size, std::span<const float> texels = {}, TextureFormat format = TextureFormat::rgba32f);

    // An image in latitude and longitude, four levels of sRGB with its curve for each texel: it goes on from its right edge at its left,
    // and has all its smaller levels, whose light is the same in the mean.
    static Texture around_a_sphere(TextureSize size, std::span<const std::uint8_t> levels);

    // Binds it to `layout(binding = ...) uniform sampler2D` (or sampler3D), or to an image that a shader writes.
    void bind_sampler(unsigned binding) const;
    void bind_image(unsigned binding) const;

    // Copies all texels as floats, channels(format) each, the first row of texture coordinates first; waits for the GPU.
    void read(std::span<float> texels) const;

    TextureSize size() const { return size_; }
    TextureFormat format() const { return format_; }
    unsigned name() const { return handle_.name(); }

private:
    Texture(TextureSize size, TextureFormat format, unsigned name) : size_(size), format_(format), handle_(name) {}

    TextureSize size_;
    TextureFormat format_;
    Handle<DeleteTexture> handle_;
};

}  // namespace airlight::gpu
