// A block of memory on the GPU that shaders read and write (std430) or read (std140).
// Uses core; knows no physics.
#pragma once

#include <cstddef>
#include <span>

#include "gpu/handle.h"

namespace airlight::gpu {

struct DeleteBuffer {
    void operator()(unsigned name) const;
};

class Buffer {
public:
    // A buffer that holds a copy of `bytes`, or `size` zero bytes. Needs a current Context, as all that follows does.
    explicit Buffer(std::span<const std::byte> bytes);
    explicit Buffer(std::size_t size);

    // Binds it to `layout(std430, binding = ...) buffer` or `layout(std140, binding = ...) uniform`.
    void bind_storage(unsigned binding) const;
    void bind_uniform(unsigned binding) const;

    // Replaces what stands at `offset`; all of it must fit.
    void write(std::span<const std::byte> bytes, std::size_t offset = 0) const;

    // Copies from its beginning to `bytes`, which may not be longer than it; waits for the GPU.
    void read(std::span<std::byte> bytes) const;

    unsigned name() const { return handle_.name(); }

private:
    Handle<DeleteBuffer> handle_;
};

}  // namespace airlight::gpu
