// Where the shadow maps lie (src/render/shadow_cascades.h). Lengths are in metres, relative to the eye, along the light's axes.
layout(std140, binding = 7) uniform ShadowBlock {
    vec4 light_right, light_up, light_towards_sun;  // .w of the last: no ground and no object is higher, above the planet's sphere
    vec4 cascade_place[8];  // middle of the square; the least height; half of the square's width
    vec4 cascade_depth[8];  // heights from the least to the greatest; a texel; the farthest distance from the eye; its map
    ivec4 shadow_count;     // of cascades; texels of a map's side
};

vec3 along_light(vec3 p) { return vec3(dot(p, light_right.xyz), dot(p, light_up.xyz), dot(p, light_towards_sun.xyz)); }

// Where a point is drawn in the map of the only cascade. Depth is 0 at the least height and 1 at the greatest.
vec4 map_position(vec3 position) {
    vec3 p = along_light(position);
    vec4 place = cascade_place[0];
    return vec4((p.xy - place.xy) / place.w, (p.z - place.z) / cascade_depth[0].x, 1.0);
}

// Of a cascade's map, in the texture that has them one above the other.
ivec2 map_corner(int cascade) { return ivec2(0, int(cascade_depth[cascade].w) * shadow_count.y); }
