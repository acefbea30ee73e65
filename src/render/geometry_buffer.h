// What is seen at each pixel, before any light: the place and the properties of the nearest surface. Deferred shading's first half.
// docs/decisions/0008-geometry-buffer.md. Uses camera and gpu.
#pragma once

#include "gpu/framebuffer.h"

namespace airlight::render {

// depth     float, near_m / distance along the camera's axis; 0 where there is nothing
// colour    reflectance of red, green and blue light, 8 bits with sRGB's curve; alpha 1 on a surface, 0 where there is nothing
// normal    octahedral, 2 x 16 bits
// material  roughness and water, 2 x 16 bits: fewer show as rings in the sun's glint
// 16 bytes a pixel. The first row is the lowest.
class GeometryBuffer {
public:
    static Result<GeometryBuffer> create(int width, int height);

    // Empties it; what is drawn from now on goes here, and hides what is farther.
    void begin() const;
    // What is drawn from now on is not tested for depth.
    static void end();

    const gpu::Texture& depth() const { return depth_; }
    const gpu::Texture& colour() const { return colour_; }
    const gpu::Texture& normal() const { return normal_; }
    const gpu::Texture& material() const { return material_; }

private:
    GeometryBuffer(gpu::Texture depth, gpu::Texture colour, gpu::Texture normal, gpu::Texture material, gpu::Framebuffer target);

    gpu::Texture depth_, colour_, normal_, material_;
    gpu::Framebuffer target_;
};

}  // namespace airlight::render
