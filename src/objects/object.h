// A body that stands free of the ground, on it, over it or beyond the air. docs/decisions/0019-objects.md.
// Uses units; knows no GPU.
#pragma once

#include <memory>

#include "objects/mesh.h"
#include "units/vector.h"

namespace airlight {

enum class Shape { sphere, box, cylinder, mesh };

struct Object {
    Shape shape;
    Vec3 centre;                                 // m from the planet's centre; of a mesh, the origin of its file
    Vec3 right, forward, up;                     // its axes, of length one and perpendicular: x, y and z of a mesh
    Vec3 half_size_m;                            // along them; a cylinder stands along `up`; of a mesh, what the file's unit is
    Vec3 reflectance;                            // of red, green and blue light, in all directions alike: 0 to 1
    std::shared_ptr<const Mesh> mesh = nullptr;  // of a mesh
};

// None of it is farther from its centre.
double reach_m(const Object& object);

}  // namespace airlight
