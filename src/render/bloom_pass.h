// Light that scatters in an eye or a lens, around all that is bright: spread over a pyramid of pictures, each half the size of the one
// before and with as large a share of the light, so that it falls with the square of the angle as the glare of eyes does [Vos1984].
// Without a threshold: light is moved, neither added nor lost.
// Uses gpu.
#pragma once

#include <vector>

#include "gpu/framebuffer.h"
#include "gpu/program.h"
#include "gpu/vertex_array.h"

namespace airlight::render {

class BloomPass {
public:
    // For pictures of this size.
    static Result<BloomPass> create(int width, int height);

    // Spreads a picture of linear light.
    void draw(const gpu::Texture& radiance) const;

    // Half the picture's size, rounded up; the corners of the first texels are the same.
    const gpu::Texture& spread() const { return levels_.front().light; }

private:
    struct Level {
        gpu::Texture light;
        gpu::Framebuffer target;
    };
    BloomPass(gpu::Program shrink, gpu::Program grow, std::vector<Level> levels);

    gpu::Program shrink_, grow_;
    std::vector<Level> levels_;
    gpu::VertexArray triangle_;
};

}  // namespace airlight::render
