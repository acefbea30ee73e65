// Free objects (src/render/object_pass.h). Positions on the GPU are relative to the eye: differences are taken in double.
#include "camera.glsl"

struct Object {
    dvec4 centre_m;            // from the planet's centre; the shape
    dvec4 right, forward, up;  // axes of length one; half of the size along each, of a mesh the unit of its corners
    vec4 reflectance, unused;
};
layout(std430, binding = 0) readonly buffer Objects { Object objects[]; };

// From the eye, of a place that is given along an object's axes in parts of its half size.
vec3 place_on(Object o, dvec3 part) {
    return vec3(o.centre_m.xyz - camera_eye_m.xyz + part.x * o.right.w * o.right.xyz + part.y * o.forward.w * o.forward.xyz +
                part.z * o.up.w * o.up.xyz);
}

mat3 axes_of(Object o) { return mat3(vec3(o.right.xyz), vec3(o.forward.xyz), vec3(o.up.xyz)); }
