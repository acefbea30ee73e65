// What a draw call reads: vertices, their attributes, and the order of triangles.
// Uses core; knows no physics.
#pragma once

#include <cstddef>
#include <initializer_list>

#include "gpu/buffer.h"
#include "gpu/handle.h"

namespace airlight::gpu {

struct DeleteVertexArray {
    void operator()(unsigned name) const;
};

// `floats` floats at `offset` in each vertex go to `layout(location = ...) in`.
struct Attribute {
    unsigned location;
    int floats;
    std::size_t offset;
};

class VertexArray {
public:
    // No vertices at all: a shader makes them from gl_VertexID.
    VertexArray();
    // Vertices of `stride` bytes in `vertices`, which outlives this.
    VertexArray(const Buffer& vertices, std::size_t stride, std::initializer_list<Attribute> attributes);
    // 16-bit indices of triangles' corners, in `indices`, which outlives this; vertices from gl_VertexID.
    static VertexArray indexed(const Buffer& indices);

    // Draws triangles, three vertices (or indices) each, `instances` times, or points, into the bound framebuffer with the program in use.
    void draw_triangles(int vertices, int instances = 1) const;
    void draw_points(int vertices) const;
    void draw_indexed(int indices, int instances = 1) const;

    unsigned name() const { return handle_.name(); }

private:
    Handle<DeleteVertexArray> handle_;
};

}  // namespace airlight::gpu
