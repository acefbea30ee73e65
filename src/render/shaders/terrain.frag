#version 450 core
// The ground and the sea into the geometry buffer.
#include "geometry_buffer.glsl"
layout(location = 0) in vec3 normal;
layout(location = 1) in vec3 root_of_reflectance;
layout(location = 2) in float height_m;

const float rough_sea = 0.2, rough_land = 1.0;

void main() {
    float water = height_m < 0.0 ? 1.0 : 0.0;
    write_surface(root_of_reflectance * root_of_reflectance, normalize(normal), mix(rough_land, rough_sea, water), water);
}
