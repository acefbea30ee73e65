// The air as one post-process over any scene that fills the geometry buffer: aerial perspective, the sky, the sun's disk, and the light
// of sun and sky on surfaces. Exact: each pixel's ray is marched by the text of the model `airlight`, four wavelengths at a time; their
// sum is a colour. From the ground to space. docs/theory.md, section 10.1. Uses models and the passes' buffers.
//
// Leaves out: shadows of surfaces on surfaces and on the air; a surface's diffuse light is that of the sky over the ground sphere.
#pragma once

#include <span>
#include <vector>

#include "camera/camera.h"
#include "gpu/buffer.h"
#include "gpu/program.h"
#include "gpu/texture.h"
#include "gpu/vertex_array.h"
#include "render/geometry_buffer.h"
#include "transport/tables.h"

namespace airlight::render {

class AirPass {
public:
    // `colours`: of radiance at each wavelength of the tables, red, green and blue, as ColourWeights says. The tables' ground sphere is
    // the planet's.
    static Result<AirPass> create(const Tables& tables, std::span<const Vec3> colours);

    // Draws into the bound framebuffer, whose colours are floats: red, green and blue; alpha means nothing. A CameraBlock of the same
    // camera is bound. Hues beyond the triangle of the primaries have negative parts.
    void draw(const GeometryBuffer& surfaces, const Camera& camera, Vec3 towards_sun) const;

private:
    // Four wavelengths.
    struct Group {
        gpu::Buffer air, colours;
        gpu::Texture densities, transmittance, source, diffuse, phases;
        void bind() const;
    };
    AirPass(gpu::Program program, std::vector<Group> groups, double bottom_m);
    // Of a pack, whose `colours` are those of its wavelengths.
    static void add_groups(const Tables::Pack& pack, std::span<const Vec3> colours, std::vector<Group>& groups);

    gpu::Program program_;
    std::vector<Group> groups_;
    double bottom_m_;
    gpu::Buffer view_;
    gpu::VertexArray triangle_;
};

}  // namespace airlight::render
