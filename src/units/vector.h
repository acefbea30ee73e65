// Vectors of space: glm's, in double precision, in metres from the planet's centre or as directions of length one.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace airlight {

using Vec3 = glm::dvec3;

}  // namespace airlight
