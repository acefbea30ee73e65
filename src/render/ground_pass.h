// What the ground and the sea look like, pixel by pixel: TerrainPass leaves in the geometry buffer what covers the ground, this pass makes
// colours of it. So a pixel is looked at once, whatever lies behind it and however small its triangles are. docs/decisions/0016-ground.md.
// Uses camera, terrain and gpu.
#pragma once

#include "camera/camera.h"
#include "gpu/buffer.h"
#include "gpu/program.h"
#include "gpu/texture.h"
#include "gpu/vertex_array.h"
#include "render/geometry_buffer.h"
#include "terrain/height_field.h"
#include "terrain/surface_image.h"

namespace airlight::render {

class GroundPass {
public:
    // Fails if the image is larger than the driver's textures.
    static Result<GroundPass> create(const HeightField& field, const GroundColour& colour = {});

    // Between begin() and end() of the geometry buffer, after TerrainPass::draw() of the same camera, whose CameraBlock is bound.
    void draw(const GeometryBuffer& surfaces, const Camera& camera) const;

private:
    GroundPass(const HeightField& field, const SurfaceImage* image, gpu::Program program);

    gpu::Program program_;
    gpu::Buffer materials_, eye_;
    gpu::Texture image_;
    gpu::VertexArray triangle_;
};

}  // namespace airlight::render
