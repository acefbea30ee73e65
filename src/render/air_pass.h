// The air as one post-process over any scene that fills the geometry buffer: aerial perspective, the sky, the sun's disk, and the light
// of sun and sky on surfaces, by any method of air. From the ground to space. Uses the passes' buffers; knows no method.
//
// Leaves out: a surface's diffuse light is that of the sky over the ground sphere.
#pragma once

#include <memory>

#include "camera/camera.h"
#include "gpu/buffer.h"
#include "gpu/program.h"
#include "gpu/vertex_array.h"
#include "render/air_method.h"
#include "render/geometry_buffer.h"

namespace airlight::render {

class AirPass {
public:
    // `air` is what `method` was made for.
    static Result<AirPass> create(const ColouredAir& air, std::unique_ptr<AirMethod> method);

    // Makes the tables of the frame that draw() draws. Binds framebuffers of its own.
    void prepare(const Camera& camera, Vec3 towards_sun, gpu::PassTimers& timers);

    // Draws into the bound framebuffer, whose colours are floats: red, green and blue; alpha means nothing. A CameraBlock of the same
    // camera is bound. Hues beyond the triangle of the primaries have negative parts. `shade`: of ShaftsPass, where anything casts a
    // shadow.
    void draw(const GeometryBuffer& surfaces, const gpu::Texture* shade = nullptr) const;

private:
    struct View {
        Four eye_up, towards_sun, shell, colour_of_sun, limb_darkening_1, limb_darkening_2, ground_albedo;
    };
    AirPass(gpu::Program program, std::unique_ptr<AirMethod> method, const View& view, double bottom_m);

    gpu::Program program_;
    std::unique_ptr<AirMethod> method_;
    View view_;
    double bottom_m_;
    gpu::Buffer view_block_;
    gpu::Texture lit_;  // the shade where there is none
    gpu::VertexArray triangle_;
};

}  // namespace airlight::render
