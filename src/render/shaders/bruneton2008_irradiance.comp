#version 450 core
// The irradiance of level surfaces by one order of light. The delta E of the paper, and its sum.
#include "bruneton2008_bake.glsl"
struct Angle { float mu, weight; };
layout(std430, binding = 3) readonly buffer Turns { vec4 turn[]; };             // [altitude][sun][angle][multiple]
layout(std430, binding = 5) readonly buffer Angles { Angle angle[]; };          // [altitude][angle]
layout(std430, binding = 6) buffer IrradianceSums { vec4 irradiance_sum[]; };   // [altitude][sun]
layout(rgba32f, binding = 0) writeonly uniform image2D delta_irradiance;        // [sun], of the ground
layout(rgba32f, binding = 1) writeonly uniform image2D irradiance;              // [altitude][sun]

void main() {
    int point = int(gl_GlobalInvocationID.x);
    if (point >= bake_altitudes * bake_suns) return;
    int altitude = point / bake_suns, sun = point % bake_suns;
    vec4 delta = vec4(0.0);
    for (int i = 0; i < bake_angles; ++i) {
        Angle a = angle[altitude * bake_angles + i];
        delta += max(a.mu, 0.0) * a.weight * turn[(point * bake_angles + i) * (bake_degree + 1)];
    }
    vec4 sum = bake_order > 1 ? irradiance_sum[point] + delta : delta;
    irradiance_sum[point] = sum;
    if (altitude == 0) imageStore(delta_irradiance, ivec2(sun, 0), logarithm_of(delta));
    imageStore(irradiance, ivec2(sun, altitude), logarithm_of(sum));
}
