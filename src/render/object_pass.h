// Free objects, drawn into the geometry buffer and into shadow maps. Spheres, boxes and cylinders are met by each pixel's ray as geometry
// says, so that they are as exact as the depth buffer at any size and distance; meshes are triangles. docs/decisions/0019-objects.md.
// Uses objects, camera and gpu.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "camera/camera.h"
#include "gpu/buffer.h"
#include "gpu/program.h"
#include "gpu/vertex_array.h"
#include "objects/object.h"
#include "render/shadow_cascades.h"

namespace airlight::render {

class ObjectPass {
public:
    static Result<ObjectPass> create(std::span<const Object> objects);

    // Draws them; an eye within a sphere, a box or a cylinder does not see it. A geometry buffer has begun, and a CameraBlock is bound.
    void draw() const;

    // Draws their depths into the bound shadow map: of spheres, boxes and cylinders that of the side away from the sun, which is in no light
    // anyway and so needs no bias; of meshes that of all triangles. A CameraBlock of the map's eye and a ShadowBlock are bound.
    void draw_depths() const;

    // What holds each of the objects.
    const std::vector<Ball>& balls() const { return balls_; }

private:
    // Those that rays meet, and those of one mesh.
    struct Solids {
        gpu::Buffer objects;
        int count;
    };
    struct Copies {
        gpu::Buffer corners, objects;
        gpu::VertexArray triangles;
        int corner_count, count;
    };
    struct Programs {
        gpu::Program solid, solid_shadow, mesh, mesh_shadow;
    };
    static Result<Programs> programs();
    ObjectPass(std::span<const Object> objects, Programs programs);
    void draw_solids(const gpu::Program& program) const;
    void draw_meshes(const gpu::Program& program) const;

    Programs programs_;
    std::vector<Ball> balls_;
    gpu::Buffer cube_;
    gpu::VertexArray cube_triangles_;
    std::optional<Solids> solids_;
    std::vector<Copies> meshes_;
};

}  // namespace airlight::render
