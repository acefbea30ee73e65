// Where the shadow maps lie (src/render/shadow_cascades.h). Lengths are in metres, relative to the eye, along the light's axes.
layout(std140, binding = 7) uniform ShadowBlock {
    vec4 light_right, light_up, light_towards_sun;  // .w of the last: no ground is higher, above the planet's sphere
    vec4 cascade_place[8];  // middle of the square; the least height; half of the square's width
    vec4 cascade_depth[8];  // heights from the least to the greatest; a texel; the farthest distance from the eye; its map
    ivec4 shadow_count;     // of cascades; texels of a map's side
};

vec3 along_light(vec3 p) { return vec3(dot(p, light_right.xyz), dot(p, light_up.xyz), dot(p, light_towards_sun.xyz)); }

// Of a cascade's map, in the texture that has them one above the other.
ivec2 map_corner(int cascade) { return ivec2(0, int(cascade_depth[cascade].w) * shadow_count.y); }
