// The solid that solid_vertex.glsl draws, to its pixels.
#include "solid.glsl"
layout(location = 0) flat in vec4 right_and_shape;
layout(location = 1) flat in vec4 forward_and_beyond;
layout(location = 2) flat in vec3 up;
layout(location = 3) flat in vec3 low;
layout(location = 4) flat in vec3 high;
layout(location = 5) flat in vec3 reflectance;

Solid drawn_solid() {
    return Solid(int(right_and_shape.w + 0.5), mat3(right_and_shape.xyz, forward_and_beyond.xyz, up), low, high, forward_and_beyond.w);
}
