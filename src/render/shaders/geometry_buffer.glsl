// What a pass that draws surfaces writes (src/render/geometry_buffer.h).
#include "octahedral.glsl"
layout(location = 0) out vec4 surface_colour;
layout(location = 1) out vec2 surface_normal;
layout(location = 2) out vec2 surface_material;

// reflectance  of red, green and blue light, in all directions alike: 0 to 1
// normal       of length one
// roughness    0 is a mirror, 1 has no highlight
// water        1 on water, 0 on land, between them at a shore
void write_surface(vec3 reflectance, vec3 normal, float roughness, float water) {
    surface_colour = vec4(reflectance, 1.0);
    surface_normal = octahedral(normal);
    surface_material = vec2(roughness, water);
}
