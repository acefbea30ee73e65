#version 450 core
// The ground and the sea into the geometry buffer.
#include "geometry_buffer.glsl"
layout(location = 0) in vec3 normal;
layout(location = 1) in vec3 root_of_reflectance;
layout(location = 2) in float height_m;
layout(location = 3) flat in vec2 depth_limits;

const float rough_sea = 0.2, rough_land = 1.0;

void main() {
    // A triangle seen edge-on, at a limb, is narrower than the rasterizer's steps: its depth between corners is then anything.
    gl_FragDepth = clamp(gl_FragCoord.z, depth_limits.x, depth_limits.y);
    float water = height_m < 0.0 ? 1.0 : 0.0;
    write_surface(root_of_reflectance * root_of_reflectance, normalize(normal), mix(rough_land, rough_sea, water), water);
}
