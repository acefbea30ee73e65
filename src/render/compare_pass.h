// Two pictures of the same view, of two methods: one beside the other, or by how much the second differs.
// Uses gpu.
#pragma once

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "gpu/texture.h"
#include "gpu/vertex_array.h"

namespace airlight::render {

class ComparePass {
public:
    static Result<ComparePass> create();

    // Draws into the bound framebuffer, whose colours are floats, the first picture up to `edge` (from 0, the left, to 1) and the second
    // from there on. All are of the same size.
    void side_by_side(const gpu::Texture& first, const gpu::Texture& second, double edge) const;

    // Draws display values, not encoded: white where both have the same luminance, more red the brighter the second is, and more blue the
    // darker, up to the share `span` of the first one's luminance.
    void difference(const gpu::Texture& first, const gpu::Texture& second, double span) const;

private:
    explicit ComparePass(gpu::Program program);
    void draw(const gpu::Texture& first, const gpu::Texture& second, bool difference, double edge, double span) const;

    gpu::Program program_;
    gpu::Buffer settings_;
    gpu::VertexArray triangle_;
};

}  // namespace airlight::render
