#version 450 core
// The light around points as a series in the azimuth: cosines of its multiples.
#include "bruneton2008_bake.glsl"
layout(std430, binding = 2) readonly buffer Radiances { vec4 radiance[]; };   // [altitude][sun][angle][azimuth]
layout(std430, binding = 3) writeonly buffer Turns { vec4 turn[]; };          // [altitude][sun][angle][multiple]
layout(std430, binding = 4) readonly buffer TurnWeights { float weight[]; };  // [azimuth][multiple]

void main() {
    int multiples = bake_degree + 1, i = int(gl_GlobalInvocationID.x);
    if (i >= bake_altitudes * bake_suns * bake_angles * multiples) return;
    int direction = i / multiples, multiple = i % multiples;
    vec4 sum = vec4(0.0);
    for (int j = 0; j < bake_azimuths; ++j) sum += radiance[direction * bake_azimuths + j] * weight[j * multiples + multiple];
    turn[i] = sum;
}
