#version 450 core
// A sphere, a box or a cylinder as the sun sees it, into the shadow map of the only cascade.
#include "solid_vertex.glsl"
#include "shadow_block.glsl"

void main() { gl_Position = map_position(solid_corner()); }
