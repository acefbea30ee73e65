#version 450 core
// The slopes of the ground at the places of a slice, and the least and the greatest in each block of places, with both of its ends, and in each
// span of blocks: Chen's tree with branches of twelve and eight.
#include "shadow.glsl"
#include "shafts_slices.glsl"
layout(local_size_x = 64) in;
layout(binding = 0, r32f) uniform writeonly image2D slopes;
layout(binding = 1, rgba32f) uniform writeonly image2D blocks;
layout(binding = 2, rgba32f) uniform writeonly image2D spans;
shared vec2 ranges[64];

// The highest ground on a line along the light; below everything if there is none. Where the finest map saw none there is none above the
// least height that it holds: what coarser ones know of is below.
float ground_on_line(vec2 across) {
    float highest = 1e30;
    for (int i = 0; i < shadow_count.x; ++i) {
        vec4 place = cascade_place[i];
        vec2 at = (across - place.xy) / place.w * 0.5 + 0.5;
        if (at != clamp(at, 0.0, 0.99999)) continue;
        float depth = texelFetch(shadow_maps, ivec2(at * float(shadow_count.y)) + map_corner(i), 0).r;
        if (depth > 0.0) return min(highest, place.z + depth * cascade_depth[i].x - 0.5 * cascade_depth[i].y);
        highest = min(highest, place.z);
    }
    return -1e20;
}

void main() {
    int block = int(gl_LocalInvocationID.x), slice = int(gl_WorkGroupID.x);
    float angle = slice_angles.x + (float(slice) + 0.5) * slice_angles.y;
    vec2 direction = vec2(cos(angle), sin(angle)), range = vec2(1e30, -1e30);
    int first = block * slice_counts.z, next = first + slice_counts.z;
    for (int k = first; k <= next; ++k) {
        float across = across_light(max(float(k), 0.5)), slope = ground_on_line(across * direction) / across;
        range = vec2(min(range.x, slope), max(range.y, slope));
        if (k < next || next == slice_counts.y) imageStore(slopes, ivec2(k, slice), vec4(slope));
    }
    imageStore(blocks, ivec2(block, slice), vec4(range, 0.0, 0.0));
    ranges[block] = range;
    barrier();
    if (block % blocks_of_span > 0) return;
    for (int i = block; i < block + blocks_of_span; ++i) range = vec2(min(range.x, ranges[i].x), max(range.y, ranges[i].y));
    imageStore(spans, ivec2(block / blocks_of_span, slice), vec4(range, 0.0, 0.0));
}
