#version 450 core
// The ground and the sea into the geometry buffer, as ground.frag reads them.
#include "geometry_buffer.glsl"
layout(location = 0) in vec3 normal;
layout(location = 1) in vec4 cover;
layout(location = 2) in float height_m;
layout(location = 3) flat in vec2 depth_limits;

const float widest_shore_m = 10.0;  // of heights in a pixel

void main() {
    // A triangle seen edge-on, at a limb, is narrower than the rasterizer's steps: its depth between corners is then anything.
    gl_FragDepth = clamp(gl_FragCoord.z, depth_limits.x, depth_limits.y);
    float shore_m = clamp(fwidth(height_m), 1e-3, widest_shore_m);
    write_cover(cover, normalize(normal), clamp(0.5 - height_m / shore_m, 0.0, 1.0));
}
