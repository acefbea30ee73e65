#version 450 core
// Counts the pixels of each luminance: each group in its own memory first, then all together.
#include "histogram.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform sampler2D radiance;
shared uint counted[bins];

void main() {
    for (uint bin = gl_LocalInvocationIndex; bin < bins; bin += 256u) counted[bin] = 0u;
    barrier();
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(pixel, textureSize(radiance, 0)))) {
        float luminance = dot(texelFetch(radiance, pixel, 0).rgb, luminance_of_rgb.rgb);
        if (luminance > 0.0 && luminance < sun_disk) atomicAdd(counted[bin_of(luminance)], 1u);
    }
    barrier();
    for (uint bin = gl_LocalInvocationIndex; bin < bins; bin += 256u)
        if (counted[bin] > 0u) atomicAdd(pixels_of_bin[bin], counted[bin]);
}
