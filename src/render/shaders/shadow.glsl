// Whether the sun sees a point (src/render/shadow_pass.h). Positions are relative to the eye, along the axes of the world; the answer
// holds for what the camera sees.
#include "shadow_block.glsl"
layout(binding = 6) uniform sampler2D shadow_maps;  // one above the other

// The finest cascade whose cube holds a point along the light's axes; -1 if there is none. Ground above a cube is drawn more coarsely.
int cascade_of(vec3 p) {
    float rim = 1.0 - 6.0 / float(shadow_count.y);  // what a filter reaches beyond is on the map as well
    for (int i = 0; i < shadow_count.x; ++i) {
        vec4 place = cascade_place[i];
        if (max(abs(p.x - place.x), abs(p.y - place.y)) <= rim * place.w && abs(p.z - place.z - place.w) <= place.w) return i;
    }
    return -1;
}

// A height in a cascade's map, half a texel higher for what rounding and the detail that texels cannot show do.
float depth_in(int cascade, float height) {
    return (height - cascade_place[cascade].z + 0.5 * cascade_depth[cascade].y) / cascade_depth[cascade].x;
}

// The part of the sun's light that reaches a surface, 0 to 1. Edges are soft by two texels: nine places between texels, each between four.
float sun_visibility(vec3 position) {
    vec3 p = along_light(position);
    int i = cascade_of(p);
    if (i < 0) return 1.0;
    vec4 place = cascade_place[i];
    float depth = depth_in(i, p.z);
    // In texels of the map; those of its four corners around are gathered at once.
    vec2 at = ((p.xy - place.xy) / place.w * 0.5 + 0.5) * float(shadow_count.y);
    vec2 corner = floor(at - 0.5), t = at - 0.5 - corner;
    vec2 scale = 1.0 / vec2(textureSize(shadow_maps, 0));
    float sum = 0.0;
    for (int y = -1; y <= 1; y += 2)
        for (int x = -1; x <= 1; x += 2) {
            vec2 middle = corner + 1.0 + vec2(x, y);
            vec4 lit = vec4(lessThanEqual(textureGather(shadow_maps, (middle + vec2(map_corner(i))) * scale), vec4(depth)));
            // A box of three texels about the point covers the outer columns and rows in part.
            vec2 left = x < 0 ? vec2(1.0 - t.x, 1.0) : vec2(1.0, t.x), low = y < 0 ? vec2(1.0 - t.y, 1.0) : vec2(1.0, t.y);
            sum += dot(lit, vec4(left.x * low.y, left.y * low.y, left.y * low.x, left.x * low.x));
        }
    return sum / 9.0;
}

// Whether the sun sees a point in the air at a distance from the eye.
bool sun_sees(vec3 direction, float distance_m) {
    int i = 0;
    while (i < shadow_count.x && cascade_depth[i].z < distance_m) ++i;
    if (i == shadow_count.x) return true;
    vec3 p = along_light(direction * distance_m);
    vec4 place = cascade_place[i];
    ivec2 at = ivec2(((p.xy - place.xy) / place.w * 0.5 + 0.5) * float(shadow_count.y));
    return texelFetch(shadow_maps, at + map_corner(i), 0).r <= depth_in(i, p.z);
}
