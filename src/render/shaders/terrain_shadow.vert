#version 450 core
// The ground as the sun sees it, into the shadow map of the only cascade.
#include "terrain_vertex.glsl"
#include "shadow_block.glsl"

void main() {
    Place patch_place;
    gl_Position = map_position(glided_vertex(patch_place).place);
}
