#version 450 core
// A sphere, a box or a cylinder as the eye sees it.
#include "solid_vertex.glsl"

void main() { gl_Position = clip_position(solid_corner()); }
