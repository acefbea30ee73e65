// The sun's light on the geometry buffer, without air: what the passes of air put their light before.
// Uses camera and gpu.
#pragma once

#include <optional>

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
    double sun_distance_au = 1.0;
    std::optional<Vec3> moon_m = {};  // the moon's centre, from the planet's
};

class LightPass {
public:
    static Result<LightPass> create();

    // Draws into the bound framebuffer: radiance, and alpha 1 on surfaces; where there is nothing the background and alpha 0. A
    // CameraBlock is bound. `shade`: of ShaftsPass, where anything casts a shadow. `background`: of BackgroundPass; without it, black.
    void draw(const GeometryBuffer& surfaces, const Lights& lights, const gpu::Texture* shade = nullptr,
              const gpu::Texture* background = nullptr) const;

private:
    explicit LightPass(gpu::Program program);
    gpu::Program program_;
    gpu::Buffer lights_;
    gpu::Texture lit_;  // the shade where there is none
    gpu::VertexArray triangle_;
};

}  // namespace airlight::render
