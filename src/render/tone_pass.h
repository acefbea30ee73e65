// The picture as a display shows it: exposed light, bent by a tone curve, in 8 bits of sRGB, dithered. The same levels as those of a PNG
// file of image/tone.h and image/png.h, to float's rounding. docs/theory.md, section 9.
// Uses image and gpu.
#pragma once

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "gpu/vertex_array.h"
#include "image/tone.h"
#include "render/bloom_pass.h"

namespace airlight::render {

class TonePass {
public:
    static Result<TonePass> create();

    // Draws into the bound framebuffer, of the picture's size and 8 bits that hold what they are given, a picture of red, green and
    // blue of linear sRGB; colours beyond the triangle of the primaries come to its edge. `exposure` is that of ExposurePass.
    void draw(const gpu::Texture& radiance, const gpu::Buffer& exposure, ToneCurve curve) const;
    // With the share `bloom`, from 0 to 1, of its light spread as `spread` says, which was drawn from it.
    void draw(const gpu::Texture& radiance, const gpu::Buffer& exposure, ToneCurve curve, const BloomPass& spread, double bloom) const;

private:
    explicit TonePass(gpu::Program program);
    void draw_with(const gpu::Texture& radiance, const gpu::Texture& spread, const gpu::Buffer& exposure, ToneCurve curve,
                   double bloom) const;

    gpu::Program program_;
    gpu::Buffer settings_;
    gpu::VertexArray triangle_;
};

}  // namespace airlight::render
