// Groups of four wavelengths of the model `airlight` on the GPU, as src/render/shaders/air_wavelengths.glsl reads them.
// Uses models and gpu.
#pragma once

#include <vector>

#include "gpu/buffer.h"
#include "gpu/texture.h"
#include "transport/tables.h"
#include "units/vector.h"

namespace airlight::render {

struct AirWavelengths {
    gpu::Buffer air, colours;
    gpu::Texture densities, transmittance, source, diffuse, phases;

    // To what the text names.
    void bind() const;
};

// All wavelengths of the tables. `colours`: of radiance at each of them. `nodes`: of a piece of a ray.
std::vector<AirWavelengths> air_wavelengths(const Tables& tables, std::span<const Vec3> colours, int nodes);

}  // namespace airlight::render
