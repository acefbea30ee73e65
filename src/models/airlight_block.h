// What a GPU is given of the model `airlight`: the uniform block of physics/models/airlight_air.glsl and texels of four wavelengths.
// Uses models/airlight_tables.h; knows no graphics library.
#pragma once

#include <cstddef>
#include <vector>

#include "models/airlight_tables.h"
#include "sky/pack_phases.h"

namespace airlight {

// Wavelengths that GLSL works on together.
inline constexpr int gpu_wavelengths = 4;

// The bytes of the block, by the rules of std140. `first`: of the four wavelengths of the pack, 0 to pack_size - 4.
std::vector<std::byte> airlight_block(const f32::AirlightAir& air, int first);

// Those of `AirlightAxis`, in a block of its own or at the beginning of another.
std::vector<std::byte> airlight_axis_block(const f32::AirlightAxis& axis);

// A table's texels, four numbers each, 0 to 1: [depth][height][width][4].
std::vector<float> gpu_texels(const PackedTexels& table, int first);
// The densities, four constituents a texel: [2][density_axis.texels][4].
std::vector<float> gpu_densities(const AirlightTables& tables);
// Phase functions, even in the root of the scattering angle, zeros of what does not scatter: [airlight_parts][samples][4].
std::vector<float> gpu_phases(const PackPhases& phases, int first);

}  // namespace airlight
