#version 450 core
// A mesh into the geometry buffer. Which side of a triangle is the outer one, files say differently: it is the one that is seen.
#include "geometry_buffer.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) flat in vec3 reflectance;

void main() {
    vec3 flat_normal = cross(dFdx(position), dFdy(position));
    float side = dot(flat_normal, position) * dot(flat_normal, normal) > 0.0 ? -1.0 : 1.0;
    write_surface(reflectance, side * normalize(normal), 1.0, 0.0);
}
