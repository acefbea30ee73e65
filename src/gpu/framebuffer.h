// Textures that a pass draws into: colours, and a depth.
// Uses core; knows no physics.
#pragma once

#include <initializer_list>

#include "core/result.h"
#include "gpu/handle.h"
#include "gpu/texture.h"

namespace airlight::gpu {

struct DeleteFramebuffer {
    void operator()(unsigned name) const;
};

class Framebuffer {
public:
    // Colour i is what a shader writes to `layout(location = i) out`. All have the same size and outlive it.
    // Fails if the driver cannot draw into such a set of formats.
    static Result<Framebuffer> create(std::initializer_list<const Texture*> colours, const Texture* depth = nullptr);

    // What is drawn from now on goes here, to the whole of it.
    void bind() const;
    void clear_colour(unsigned index, float red, float green, float blue, float alpha) const;
    void clear_depth(float depth) const;

    unsigned name() const { return handle_.name(); }

private:
    explicit Framebuffer(TextureSize size);

    TextureSize size_;
    Handle<DeleteFramebuffer> handle_;
};

}  // namespace airlight::gpu
