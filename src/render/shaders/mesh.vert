#version 450 core
// A mesh as the eye sees it.
#include "object.glsl"
layout(location = 0) in vec3 corner;
layout(location = 1) in vec3 corner_normal;
layout(location = 0) out vec3 position;
layout(location = 1) out vec3 normal;
layout(location = 2) flat out vec3 reflectance;

void main() {
    Object o = objects[gl_InstanceID];
    position = place_on(o, dvec3(corner)), normal = axes_of(o) * corner_normal, reflectance = o.reflectance.rgb;
    gl_Position = clip_position(position);
}
