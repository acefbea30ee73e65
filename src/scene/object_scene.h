// An object as a scene says it: what it is, how large, and where it stands. docs/scene-file.md.
// Uses camera and objects.
#pragma once

#include <filesystem>

#include "camera/camera.h"
#include "objects/object.h"

namespace airlight {

struct ObjectScene {
    Shape shape = Shape::sphere;
    // The middle of what it stands on, of a mesh its file's origin; its pitch is below 0 where it leans towards its heading.
    Viewpoint foot;
    bool above_ground = false;   // the foot's altitude is above the ground, or the sea, instead
    Vec3 size_m = Vec3(1.0);     // from left to right, from behind to before, from below to above; of a mesh, the file's unit
    std::filesystem::path mesh;  // of a mesh
    Vec3 reflectance = Vec3(0.5);

    friend bool operator==(const ObjectScene&, const ObjectScene&) = default;
};

}  // namespace airlight
