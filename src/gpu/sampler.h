// How texels are read, apart from the textures that hold them.
// Uses core; knows no physics.
#pragma once

#include "gpu/handle.h"

namespace airlight::gpu {

struct DeleteSampler {
    void operator()(unsigned name) const;
};

enum class Filter { nearest, linear };
enum class Wrap { clamp, repeat };

class Sampler {
public:
    Sampler(Filter filter, Wrap wrap);

    // Reads of the texture at `binding` follow this sampler until unbind(binding).
    void bind(unsigned binding) const;
    static void unbind(unsigned binding);

    unsigned name() const { return handle_.name(); }

private:
    Handle<DeleteSampler> handle_;
};

}  // namespace airlight::gpu
