// A table of four floats a texel on the GPU, two- or three-dimensional, read with linear filtering and clamped edges.
// Uses core; knows no physics.
#pragma once

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

class Texture {
public:
    // `texels` has 4 floats for each texel, width fastest, then height; empty leaves the texture undefined.
    explicit Texture(TextureSize size, std::span<const float> texels = {});

    // Binds it to `layout(binding = ...) uniform sampler2D` (or sampler3D), or to an image that a shader writes.
    void bind_sampler(unsigned binding) const;
    void bind_image(unsigned binding) const;

    // Copies all texels, 4 floats each; waits for the GPU.
    void read(std::span<float> texels) const;

    TextureSize size() const { return size_; }
    unsigned name() const { return handle_.name(); }

private:
    TextureSize size_;
    Handle<DeleteTexture> handle_;
};

}  // namespace airlight::gpu
