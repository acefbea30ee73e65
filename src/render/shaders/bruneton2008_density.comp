#version 450 core
// What of one order's light is scattered once more, by direction: the delta J of the paper, over the scattering coefficient; and its sum.
#include "bruneton2008_bake.glsl"
layout(std430, binding = 6) readonly buffer Moments { vec4 moment[]; };         // [altitude][sun][degree][multiple]
layout(std430, binding = 4) readonly buffer Legendres { float legendre[]; };    // [view][degree][multiple]
layout(std430, binding = 5) readonly buffer Cosines { float cosine[]; };        // [azimuth][multiple]
layout(std430, binding = 3) buffer DensitySums { vec4 density_sum[]; };         // [altitude][azimuth][view][sun]
layout(rgba32f, binding = 0) writeonly uniform image3D delta_density;           // [azimuth and altitude][view][sun]
layout(rgba32f, binding = 1) writeonly uniform image3D density;

void main() {
    int multiples = bake_degree + 1, count = multiples * multiples, i = int(gl_GlobalInvocationID.x);
    int suns = air.sun_texels, views = air.view_texels, azimuths = air.azimuth_texels;
    if (i >= bake_altitudes * azimuths * views * suns) return;
    int sun = i % suns, view = i / suns % views, azimuth = i / (suns * views) % azimuths, altitude = i / (suns * views * azimuths);
    vec4 delta = vec4(0.0);
    for (int degree = 0; degree <= bake_degree; ++degree)
        for (int multiple = 0; multiple <= degree; ++multiple) {
            int c = degree * multiples + multiple;
            delta += moment[(altitude * bake_suns + sun) * count + c] * (legendre[view * count + c] * cosine[azimuth * multiples + multiple]);
        }
    // A series that is cut may ring below zero in the dark; the night stays dark.
    delta = sun > 0 ? max(delta, vec4(0.0)) : vec4(0.0);
    vec4 sum = bake_order > 1 ? density_sum[i] + delta : delta;
    density_sum[i] = sum;
    ivec3 texel = ivec3(sun, view, altitude + azimuth * bake_altitudes);
    imageStore(delta_density, texel, logarithm_of(delta));
    imageStore(density, texel, logarithm_of(sum));
}
