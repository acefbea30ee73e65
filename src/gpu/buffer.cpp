#include "gpu/buffer.h"

#include <epoxy/gl.h>

#include <vector>

namespace airlight::gpu {

namespace {

unsigned create(const void* bytes, std::size_t size) {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    glNamedBufferStorage(name, static_cast<GLsizeiptr>(size), bytes, GL_DYNAMIC_STORAGE_BIT);
    return name;
}

}  // namespace

void DeleteBuffer::operator()(unsigned name) const { glDeleteBuffers(1, &name); }

Buffer::Buffer(std::span<const std::byte> bytes) : handle_(create(bytes.data(), bytes.size())) {}
Buffer::Buffer(std::size_t size) : Buffer(std::vector<std::byte>(size)) {}

void Buffer::bind_storage(unsigned binding) const { glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, name()); }
void Buffer::bind_uniform(unsigned binding) const { glBindBufferBase(GL_UNIFORM_BUFFER, binding, name()); }

void Buffer::write(std::span<const std::byte> bytes, std::size_t offset) const {
    glNamedBufferSubData(name(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes.size()), bytes.data());
}

void Buffer::read(std::span<std::byte> bytes) const {
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(name(), 0, static_cast<GLsizeiptr>(bytes.size()), bytes.data());
}

}  // namespace airlight::gpu
