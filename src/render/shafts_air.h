// The air as light shafts need it: what it scatters once towards an eye, from where on the way, at three wavelengths that stand for red,
// green and blue. Shafts are shares of a method's light, so that this needs to know how light is spread along a ray, not how much it is.
// Uses atmosphere, transport's columns and gpu.
#pragma once

#include "atmosphere/atmosphere.h"
#include "gpu/texture.h"

namespace airlight::render {

class ShaftsAir {
public:
    // At most max_columns constituents (asserted).
    explicit ShaftsAir(const Atmosphere& atmosphere);

    // For programs that include shafts_air.glsl.
    void bind() const;

private:
    gpu::Texture profiles_;  // by altitude: extinction in the first row, then what each scatters that does, m-1
    gpu::Texture phases_;  // of each constituent, even in the root of the scattering angle, sr-1; alpha: 1 if it has a peak; last, the sum
                           // of those that have
    gpu::Texture sun_depth_;  // optical depths towards the sun, by altitude and zenith cosine
};

}  // namespace airlight::render
