#version 450 core
// The light around points in spherical harmonics, scattered: each degree times the moment of the phase function there.
#include "bruneton2008_bake.glsl"
layout(std430, binding = 3) readonly buffer Turns { vec4 turn[]; };            // [altitude][sun][angle][multiple]
layout(std430, binding = 4) readonly buffer Legendres { float legendre[]; };   // [altitude][angle][degree][multiple], times weights
layout(std430, binding = 5) readonly buffer Factors { vec4 factor[]; };        // [altitude][degree]
layout(std430, binding = 6) writeonly buffer Moments { vec4 moment[]; };       // [altitude][sun][degree][multiple]

void main() {
    int multiples = bake_degree + 1, count = multiples * multiples, i = int(gl_GlobalInvocationID.x);
    if (i >= bake_altitudes * bake_suns * count) return;
    int point = i / count, altitude = point / bake_suns, degree = i % count / multiples, multiple = i % multiples;
    if (multiple > degree) return;
    vec4 sum = vec4(0.0);
    for (int a = 0; a < bake_angles; ++a)
        sum += turn[(point * bake_angles + a) * multiples + multiple] * legendre[(altitude * bake_angles + a) * count + i % count];
    moment[i] = sum * factor[altitude * multiples + degree];
}
