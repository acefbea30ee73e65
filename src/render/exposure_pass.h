// Auto exposure on the GPU: a histogram of the picture's luminance, its mean, and an exposure that follows it from frame to frame. Nothing
// comes back to the CPU unless it is asked for. docs/theory.md, section 9.
// Uses image and gpu.
#pragma once

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "gpu/texture.h"
#include "image/adaptation.h"
#include "image/exposure.h"

namespace airlight::render {

class ExposurePass {
public:
    static Result<ExposurePass> create();

    // Meters a picture of red, green and blue of linear sRGB in cd m-2, as image/exposure.h does but for luminance within 1/24 stop
    // (half a bin), and what is darker than 4e-6 cd m-2 counts as that. Then goes on from the exposure of before, over `seconds` >= 0;
    // with none before, or with infinity, it is there at once. A picture without light changes nothing.
    void meter(const gpu::Texture& radiance, const Metering& metering, const Adaptation& adaptation, double seconds) const;

    // From here on; above 0. Not metered.
    void set(double exposure) const;

    // `layout(std430) buffer { float exposure; }`: 0 before the first of meter() and set().
    const gpu::Buffer& exposure() const { return exposure_; }
    // The same here; waits for the GPU.
    double read() const;

private:
    ExposurePass(gpu::Program histogram, gpu::Program follow);

    gpu::Program count_, follow_;
    gpu::Buffer histogram_, settings_, exposure_;
};

}  // namespace airlight::render
