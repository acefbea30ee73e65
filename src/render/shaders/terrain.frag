#version 450 core
// The ground and the sea into the geometry buffer, as ground.frag reads them.
#include "geometry_buffer.glsl"
layout(location = 0) in vec3 normal;
layout(location = 1) in vec3 cover;  // steppe, rock, snow
layout(location = 2) in float height_m;
layout(location = 3) flat in vec2 depth_limits;

const float widest_shore_m = 200.0;  // of heights in a pixel: where they differ more, they are mountains
const vec2 beach_m = vec2(2.0, 30.0);  // sand up to the first height, none from the second on

// Height of ground from the sea up to a height, counted by its share of sand.
float sand_below(float height_m) {
    float width = beach_m.y - beach_m.x, left = clamp((beach_m.y - height_m) / width, 0.0, 1.0);
    return clamp(height_m, 0.0, beach_m.x) + 0.5 * width * (1.0 - left * left);
}

void main() {
    // A triangle seen edge-on, at a limb, is narrower than the rasterizer's steps: its depth between corners is then anything.
    gl_FragDepth = clamp(gl_FragCoord.z, depth_limits.x, depth_limits.y);
    // Heights in the pixel, and what of them is sand or water: a beach is as wide as it is, however far.
    float span_m = max(length(vec2(dFdx(height_m), dFdy(height_m))), 1e-3), low = max(height_m - 0.5 * span_m, 0.0), high = height_m + 0.5 * span_m;
    float sand = high > low ? (sand_below(high) - sand_below(low)) / (high - low) : 1.0;
    float below = clamp(0.5 - height_m / min(span_m, widest_shore_m), 0.0, 1.0);
    write_cover(vec4(cover.x, sand, cover.yz), normalize(normal), below);
}
