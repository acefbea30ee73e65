#version 450 core
// Counts the pixels of each luminance: each group in its own memory first, then all together.
#include "histogram.glsl"
const int side = 16, times = 4;  // a group counts a square of side x times pixels each way: more than there are bins
layout(local_size_x = side, local_size_y = side) in;
layout(binding = 0) uniform sampler2D radiance;
shared uint counted[bins];

void count(ivec2 pixel) {
    if (any(greaterThanEqual(pixel, textureSize(radiance, 0)))) return;
    float luminance = dot(texelFetch(radiance, pixel, 0).rgb, luminance_of_rgb.rgb);
    if (luminance > 0.0 && luminance < sun_disk) atomicAdd(counted[bin_of(luminance)], 1u);
}

void main() {
    for (int bin = int(gl_LocalInvocationIndex); bin < bins; bin += side * side) counted[bin] = 0u;
    barrier();
    ivec2 first = ivec2(gl_WorkGroupID.xy) * side * times + ivec2(gl_LocalInvocationID.xy);
    for (int i = 0; i < times * times; ++i) count(first + side * ivec2(i % times, i / times));
    barrier();
    for (int bin = int(gl_LocalInvocationIndex); bin < bins; bin += side * side)
        if (counted[bin] > 0u) atomicAdd(pixels_of_bin[bin], counted[bin]);
}
