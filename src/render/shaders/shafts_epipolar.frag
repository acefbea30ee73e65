#version 450 core
// Light shafts on epipolar slices [Engelhardt2010] with the least and greatest ground of each part of a slice [Chen2011; Yusov2014]: the
// shadow maps are read once for each slice, not for each ray, and a ray asks most parts of its slice one question: is all of it below
// you, or above? Where neither, shadows begin and end where the ray meets the line between two places of ground. Approximates: a ray lies
// between two slices, and ground is straight between places, one to two percent of their distance apart. Cost: 0.3 million
// places on slices a frame; for each pixel a look at each part, and two at the table of light scattered once for each edge.
#include "shafts_light.glsl"
#include "shafts_slices.glsl"
layout(binding = 12) uniform sampler2D slopes;
layout(binding = 13) uniform sampler2D blocks;
layout(binding = 15) uniform sampler2D spans;

const float two_pi = 6.28318530718;

// Whether some of the ground on two slices is lower than a ray, and some higher; x and z are the least slopes, y and w the greatest.
bool between(float slope, vec4 range) { return max(range.y, range.w) > slope && min(range.x, range.z) <= slope; }

float way_to(int place, float sine, AirRay start) { return across_light(float(place)) / sine - start.empty; }

vec2 slopes_at(int place, ivec2 slices) {
    return vec2(texelFetch(slopes, ivec2(place, slices.x), 0).r, texelFetch(slopes, ivec2(place, slices.y), 0).r);
}

// The share of a way that passes ground, whose slope goes evenly from one to another.
vec2 lit_between(vec2 here, vec2 there, float slope) {
    vec2 low = min(here, there), high = max(here, there);
    return clamp((slope - low) / max(high - low, 1e-20), 0.0, 1.0);
}

vec3 lit_share(vec2 place, vec3 direction, AirRay start, float way, vec2 part) {
    vec3 light_axes = along_light(direction);
    float sine = max(length(light_axes.xy), 1e-6), slope = light_axes.z / sine;
    float turn = fract((atan(light_axes.y, light_axes.x) - slice_angles.x) / two_pi) * two_pi;
    // The slices on both sides of the ray, and how near the second is.
    float at = turn / slice_angles.y - 0.5, second = fract(at);
    ivec2 slices = ivec2(int(floor(at))) + ivec2(0, 1);
    slices = slice_counts.w == 1 ? (slices + slice_counts.x) % slice_counts.x : clamp(slices, 0, slice_counts.x - 1);
    float end = min(place_across((start.empty + part.y) * sine), float(slice_counts.y));
    int k = int(place_across((start.empty + part.x) * sine));
    ShaftsView view = shafts_view(place, direction, start);
    LitSum sum = lit_from_the_eye();
    float from = part.x;
    while (float(k) < end) {
        int block = k / slice_counts.z, span = block / blocks_of_span, next = (span + 1) * blocks_of_span * slice_counts.z;
        vec4 range = vec4(texelFetch(spans, ivec2(span, slices.x), 0).rg, texelFetch(spans, ivec2(span, slices.y), 0).rg);
        if (between(slope, range)) {
            next = (block + 1) * slice_counts.z;
            range = vec4(texelFetch(blocks, ivec2(block, slices.x), 0).rg, texelFetch(blocks, ivec2(block, slices.y), 0).rg);
        }
        if (!between(slope, range)) {
            go_on(sum, view, from, range.x <= slope ? 1.0 : 0.0);
            k = next, from = way_to(k, sine, start);
            continue;
        }
        for (vec2 here = slopes_at(k, slices), there; k < next && float(k) < end; here = there) {
            there = slopes_at(k + 1, slices);
            vec2 lit = lit_between(here, mix(here, there, min(end - float(k), 1.0)), slope);
            go_on(sum, view, from, mix(lit.x, lit.y, second));
            from = way_to(++k, sine, start);
        }
    }
    go_on(sum, view, part.y, 1.0);
    return share_at_end(sum, view, way);
}
#include "shafts.glsl"
