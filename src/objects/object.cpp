#include "objects/object.h"

namespace airlight {

double reach_m(const Object& object) {
    switch (object.shape) {
        case Shape::sphere:
            return object.half_size_m.x;
        case Shape::mesh:
            return object.mesh->reach * object.half_size_m.x;
        case Shape::box:
        case Shape::cylinder:
            break;
    }
    return glm::length(object.half_size_m);
}

}  // namespace airlight
