// Light shafts: the air between the eye and a surface, where ground or anything else stands between it and the sun, scatters no sunlight
// towards the eye. And the shadows on surfaces. docs/decisions/0013-shadows.md. Uses the pass of shadows; knows no method of air.
//
// Its methods differ in how they find the lit parts of a ray; each says at the head of its shader whose it is, what it approximates and
// what it costs. Leaves out: that light which was scattered twice and more is weaker in the shadow too.
#pragma once

#include <optional>
#include <string_view>

#include "gpu/vertex_array.h"
#include "render/geometry_buffer.h"
#include "render/shadow_pass.h"
#include "render/shafts_air.h"

namespace airlight::render {

enum class Shafts { epipolar, marched, planes, volumes, brute, none };

class ShaftsPass {
public:
    // For pictures of a size. Without `air` there are only the shadows on surfaces. A method is asked for a ray of each square of
    // `pixels_of_ray` x `pixels_of_ray` pixels.
    static Result<ShaftsPass> create(int width, int height, Shafts method, const Atmosphere* air, int pixels_of_ray = 2);

    // Draws into a texture of its own. The shadows are those of `camera`, whose CameraBlock is bound; with air, AirPass::prepare() has
    // been called for both.
    void draw(const GeometryBuffer& surfaces, const ShadowPass& shadows, const Camera& camera) const;

    // For each pixel, the lowest row first: of the light that the air scatters once towards the eye, the share that stays, in red, green
    // and blue; and the share of the sun's light that reaches the surface.
    const gpu::Texture& shade() const { return shade_; }

private:
    struct Table {
        gpu::Program program;
        gpu::Texture even, peaked;
    };
    struct SlicesOfMaps {
        int count;
        gpu::Program program;
        gpu::Texture slopes, blocks, spans;
        gpu::Buffer block;
    };
    struct Rays {
        gpu::Program program;
        gpu::Texture lit;
        gpu::Framebuffer target;
        gpu::Buffer block;
        ShaftsAir air;
        std::optional<Table> table;
        std::optional<SlicesOfMaps> slices;
    };
    static Result<Rays> rays_of(int width, int height, Shafts method, const Atmosphere& air, int pixels_of_ray);
    ShaftsPass(gpu::Program program, gpu::Texture shade, gpu::Framebuffer target, std::optional<Rays> rays);
    void draw_rays(const ShadowPass& shadows, const Camera& camera) const;
    static void draw_slices(const SlicesOfMaps& slices, const ShadowPass& shadows, const Camera& camera);

    gpu::Program program_;
    gpu::Texture shade_;
    gpu::Framebuffer target_;
    std::optional<Rays> rays_;
    gpu::VertexArray triangle_;
};

}  // namespace airlight::render
