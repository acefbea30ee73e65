#include "gpu/vertex_array.h"

#include <epoxy/gl.h>

namespace airlight::gpu {

namespace {

unsigned create() {
    GLuint name = 0;
    glCreateVertexArrays(1, &name);
    return name;
}

}  // namespace

void DeleteVertexArray::operator()(unsigned name) const { glDeleteVertexArrays(1, &name); }

VertexArray::VertexArray() : handle_(create()) {}

VertexArray::VertexArray(const Buffer& vertices, std::size_t stride, std::initializer_list<Attribute> attributes) : VertexArray() {
    glVertexArrayVertexBuffer(name(), 0, vertices.name(), 0, static_cast<GLsizei>(stride));
    for (const Attribute& a : attributes) {
        glEnableVertexArrayAttrib(name(), a.location);
        glVertexArrayAttribFormat(name(), a.location, a.floats, GL_FLOAT, GL_FALSE, static_cast<GLuint>(a.offset));
        glVertexArrayAttribBinding(name(), a.location, 0);
    }
}

VertexArray VertexArray::indexed(const Buffer& indices) {
    VertexArray array;
    glVertexArrayElementBuffer(array.name(), indices.name());
    return array;
}

void VertexArray::draw_triangles(int vertices, int instances) const {
    glBindVertexArray(name());
    glDrawArraysInstanced(GL_TRIANGLES, 0, vertices, instances);
}

void VertexArray::draw_points(int vertices) const {
    glBindVertexArray(name());
    glDrawArrays(GL_POINTS, 0, vertices);
}

void VertexArray::draw_indexed(int indices, int instances) const {
    glBindVertexArray(name());
    glDrawElementsInstanced(GL_TRIANGLES, indices, GL_UNSIGNED_SHORT, nullptr, instances);
}

}  // namespace airlight::gpu
