// What the shader of the ground reads beside its vertices: its materials and, where there is one, the planet's image.
// Uses terrain and gpu.
#pragma once

#include "gpu/buffer.h"
#include "gpu/texture.h"
#include "terrain/height_field.h"
#include "terrain/surface_image.h"

namespace airlight::render {

class GroundTextures {
public:
    // Fails if the image is larger than the driver's textures.
    static Result<GroundTextures> create(const HeightField& field, const GroundColour& colour);

    // For terrain.frag.
    void bind() const;

private:
    GroundTextures(const HeightField& field, const SurfaceImage* image);

    gpu::Buffer block_;
    gpu::Texture image_;
};

}  // namespace airlight::render
