#version 450 core
// Light shafts on epipolar slices [Engelhardt2010] with the least and greatest ground of each part of a slice [Chen2011; Yusov2014]: the
// shadow maps are read once for each slice, not for each ray, and a ray asks most parts of its slice one question: is all of it below
// you, or above? Approximates: a ray lies between two slices, and shadows begin at the places of its slice, half a
// percent of their distance apart. Cost: a million places on slices a frame; for each pixel a look at each part, and two
// at the table of light scattered once for each edge.
#include "shafts_light.glsl"
#include "shafts_slices.glsl"
layout(binding = 12) uniform sampler2D slopes;
layout(binding = 13) uniform sampler2D blocks;
layout(binding = 15) uniform sampler2D spans;

const float two_pi = 6.28318530718;

// The share of the places from `first` to before `last` on a slice, within a block, that lie below a ray.
float lit_places(int slice, int block, int first, int last, float slope) {
    vec2 range = texelFetch(blocks, ivec2(block, slice), 0).rg;
    if (range.y <= slope) return 1.0;
    if (range.x > slope) return 0.0;
    int lit = 0;
    for (int k = first; k < last; ++k)
        if (texelFetch(slopes, ivec2(k, slice), 0).r <= slope) ++lit;
    return float(lit) / float(last - first);
}

vec3 lit_share(vec2 place, vec3 direction, AirRay start, float way, vec2 part) {
    vec3 light_axes = along_light(direction);
    float sine = max(length(light_axes.xy), 1e-6), slope = light_axes.z / sine;
    float turn = fract((atan(light_axes.y, light_axes.x) - slice_angles.x) / two_pi) * two_pi;
    // The slices on both sides of the ray, and how near the second is.
    float at = turn / slice_angles.y - 0.5, second = fract(at);
    ivec2 slices = ivec2(int(floor(at))) + ivec2(0, 1);
    slices = slice_counts.w == 1 ? (slices + slice_counts.x) % slice_counts.x : clamp(slices, 0, slice_counts.x - 1);
    int first = int(place_across((start.empty + part.x) * sine));
    // A place beyond the ray's end says nothing of it: a part too short for any is lit.
    int last = clamp(int(place_across((start.empty + part.y) * sine) + 0.5), first, slice_counts.y);
    ShaftsView view = shafts_view(place, direction, start);
    LitSum sum = lit_from_the_eye();
    float from = part.x;
    for (int k = first; k < last && from < part.y;) {
        int block = k / slice_counts.z, span = block / blocks_of_span, next = (span + 1) * blocks_of_span * slice_counts.z;
        vec2 one = texelFetch(spans, ivec2(span, slices.x), 0).rg, other = texelFetch(spans, ivec2(span, slices.y), 0).rg;
        float share = max(one.y, other.y) <= slope ? 1.0 : 0.0;
        if (share == 0.0 && min(one.x, other.x) <= slope) {
            next = min((block + 1) * slice_counts.z, last);
            share = mix(lit_places(slices.x, block, k, next, slope), lit_places(slices.y, block, k, next, slope), second);
        }
        next = min(next, last);
        go_on(sum, view, from, share);
        from = across_light(float(next)) / sine - start.empty;
        k = next;
    }
    go_on(sum, view, part.y, 1.0);
    return share_at_end(sum, view, way);
}
#include "shafts.glsl"
