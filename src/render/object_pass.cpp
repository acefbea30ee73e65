#include "render/object_pass.h"

#include <epoxy/gl.h>

#include <array>
#include <cstdint>
#include <map>
#include <utility>

#include "render/shaders.h"

namespace airlight::render {

namespace {

constexpr unsigned objects_binding = 0;

// std430: `Object` of src/render/shaders/object.glsl.
struct Record {
    std::array<double, 4> centre, right, forward, up;  // and the shape; half of the size along each axis
    std::array<float, 4> reflectance;
    std::array<float, 4> unused;
};
static_assert(sizeof(Record) == 160);

std::array<double, 4> four(Vec3 v, double w) { return {v.x, v.y, v.z, w}; }

Record record_of(const Object& o) {
    const auto share = [](double x) { return static_cast<float>(x); };
    return {four(o.centre, static_cast<double>(o.shape)),
            four(o.right, o.half_size_m.x),
            four(o.forward, o.half_size_m.y),
            four(o.up, o.half_size_m.z),
            {share(o.reflectance.x), share(o.reflectance.y), share(o.reflectance.z), 0.0f},
            {}};
}

// Corners of a cube by the bits of their numbers, x, y and z; counter-clockwise from outside.
constexpr std::array<std::uint16_t, 36> cube_corners = {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                                                        2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};

}  // namespace

Result<ObjectPass::Programs> ObjectPass::programs() {
    Result<gpu::Program> solid = program("solid.vert", "solid.frag");
    if (!solid) return solid.error();
    Result<gpu::Program> solid_shadow = program("solid_shadow.vert", "solid_shadow.frag");
    if (!solid_shadow) return solid_shadow.error();
    Result<gpu::Program> mesh = program("mesh.vert", "mesh.frag");
    if (!mesh) return mesh.error();
    Result<gpu::Program> mesh_shadow = program("mesh_shadow.vert", "depth.frag");
    if (!mesh_shadow) return mesh_shadow.error();
    return Programs{*std::move(solid), *std::move(solid_shadow), *std::move(mesh), *std::move(mesh_shadow)};
}

Result<ObjectPass> ObjectPass::create(std::span<const Object> objects) {
    Result<Programs> made = programs();
    if (!made) return made.error();
    return ObjectPass(objects, *std::move(made));
}

ObjectPass::ObjectPass(std::span<const Object> objects, Programs programs)
    : programs_(std::move(programs)), cube_(std::as_bytes(std::span(cube_corners))), cube_triangles_(gpu::VertexArray::indexed(cube_)) {
    std::map<const Mesh*, std::vector<Record>> by_mesh;
    for (const Object& object : objects) {
        by_mesh[object.mesh.get()].push_back(record_of(object));
        balls_.push_back({object.centre, reach_m(object)});
    }
    for (const auto& [mesh, records] : by_mesh) {
        gpu::Buffer copies(std::as_bytes(std::span(records)));
        const int count = static_cast<int>(records.size());
        if (!mesh) {
            solids_.emplace(Solids{std::move(copies), count});
            continue;
        }
        gpu::Buffer corners(std::as_bytes(std::span(mesh->corners)));
        gpu::VertexArray triangles(corners, sizeof(MeshCorner),
                                   {{0, 3, offsetof(MeshCorner, place)}, {1, 3, offsetof(MeshCorner, normal)}});
        meshes_.push_back({std::move(corners), std::move(copies), std::move(triangles), static_cast<int>(mesh->corners.size()), count});
    }
}

void ObjectPass::draw() const {
    draw_solids(programs_.solid);
    draw_meshes(programs_.mesh);
}

void ObjectPass::draw_depths() const {
    draw_solids(programs_.solid_shadow);
    draw_meshes(programs_.mesh_shadow);
}

// Boxes about them, of which the far sides ask each pixel's ray: so they do from within such a box as well.
void ObjectPass::draw_solids(const gpu::Program& program) const {
    if (!solids_) return;
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    program.use();
    solids_->objects.bind_storage(objects_binding);
    cube_triangles_.draw_indexed(static_cast<int>(cube_corners.size()), solids_->count);
    glDisable(GL_CULL_FACE);
}

void ObjectPass::draw_meshes(const gpu::Program& program) const {
    program.use();
    for (const Copies& mesh : meshes_) {
        mesh.objects.bind_storage(objects_binding);
        mesh.triangles.draw_triangles(mesh.corner_count, mesh.count);
    }
}

}  // namespace airlight::render
