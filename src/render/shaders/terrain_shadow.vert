#version 450 core
// The ground as the sun sees it, into the shadow map of the only cascade. Depth is 0 at the least height and 1 at the greatest.
#include "terrain_vertex.glsl"
#include "shadow_block.glsl"

void main() {
    Place patch_place;
    vec3 p = along_light(glided_vertex(patch_place).place);
    vec4 place = cascade_place[0];
    gl_Position = vec4((p.xy - place.xy) / place.w, (p.z - place.z) / cascade_depth[0].x, 1.0);
}
