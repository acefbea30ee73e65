// What a pass that draws surfaces writes (src/render/geometry_buffer.h).
#include "octahedral.glsl"
layout(location = 0) out vec4 surface_colour;
layout(location = 1) out vec2 surface_normal;
layout(location = 2) out vec2 surface_material;

// reflectance  of red, green and blue light, in all directions alike: 0 to 1
// normal       of length one
// roughness    0 is a mirror, 1 has no highlight; where water is a part, that of the water
// water        1 on water, 0 on land, between them at a shore
void write_surface(vec3 reflectance, vec3 normal, float roughness, float water) {
    surface_colour = vec4(reflectance, 1.0);
    surface_normal = octahedral(normal);
    surface_material = vec2(roughness, water);
}

// Ground that waits for its looks (ground.frag): what covers it stands where they will, and its alpha says so.
//   cover  of steppe, sand, rock and snow (src/terrain/ground_cover.h)
//   below  1 below 0 m, 0 above, between them at a shore
const float alpha_of_cover = 0.5;
void write_cover(vec4 cover, vec3 normal, float below) {
    surface_colour = vec4(cover.xzw, alpha_of_cover);
    surface_normal = octahedral(normal);
    surface_material = vec2(cover.y, below);
}
