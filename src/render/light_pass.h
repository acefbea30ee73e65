// The sun's light on the geometry buffer, without air: what the passes of air put their light before.
// Uses camera and gpu.
#pragma once

#include "gpu/program.h"
#include "gpu/vertex_array.h"
#include "render/geometry_buffer.h"
#include "units/vector.h"

namespace airlight::render {

// Red, green and blue in any one unit of irradiance; the picture is in that unit a steradian.
struct Lights {
    Vec3 towards_sun;  // of length one
    Vec3 sun;          // on a surface that faces it
    Vec3 sky;          // on level ground, from all of the sky alike, while the sun is up
};

class LightPass {
public:
    static Result<LightPass> create();

    // Draws into the bound framebuffer: radiance, and alpha 1 on surfaces; 0, 0, 0, 0 where there is nothing. A CameraBlock is bound.
    // `shade`: of ShaftsPass, where anything casts a shadow.
    void draw(const GeometryBuffer& surfaces, const Lights& lights, const gpu::Texture* shade = nullptr) const;

private:
    explicit LightPass(gpu::Program program);
    gpu::Program program_;
    gpu::Buffer lights_;
    gpu::Texture lit_;  // the shade where there is none
    gpu::VertexArray triangle_;
};

}  // namespace airlight::render
