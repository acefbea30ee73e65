#version 450 core
// A mesh as the sun sees it, into the shadow map of the only cascade.
#include "object.glsl"
#include "shadow_block.glsl"
layout(location = 0) in vec3 corner;

void main() { gl_Position = map_position(place_on(objects[gl_InstanceID], dvec3(corner))); }
