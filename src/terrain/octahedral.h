// A direction in two numbers: the sphere unfolded over an octahedron into a square [Cigolle2014, section 4].
// The same map as src/render/shaders/octahedral.glsl. Uses units.
#pragma once

#include <cstdint>

#include "units/vector.h"

namespace airlight {

// Two numbers of 16 bits, x in the lower ones: what GLSL's unpackUnorm2x16 reads.
std::uint32_t octahedral(Vec3 direction);
Vec3 from_octahedral(std::uint32_t packed);

}  // namespace airlight
