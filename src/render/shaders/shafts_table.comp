#version 450 core
// One column of the table of light scattered once.
#include "camera.glsl"
#include "shafts_table.glsl"
layout(local_size_x = 8, local_size_y = 6) in;
layout(binding = 0, rgba32f) uniform writeonly image3D even_light;
layout(binding = 1, rgba32f) uniform writeonly image3D peaked_light;

// Light is kept over the way, and over the peak: so it interpolates well.
void keep(ivec3 texel, vec3 even, vec3 peaked) {
    imageStore(even_light, texel, vec4(even, 0.0));
    imageStore(peaked_light, texel, vec4(peaked, 0.0));
}

void main() {
    ivec3 size = imageSize(even_light);
    ivec2 column = ivec2(gl_GlobalInvocationID.xy);
    vec3 direction = normalize(view_ray(vec2(column) / vec2(size.xy - 1) * 2.0 - 1.0));
    AirRay start;
    bool air = enter_air(direction, start);
    vec3 depth = vec3(0.0), even = vec3(0.0), peaked = vec3(0.0), peak = max(peak_towards(direction), 1e-9);
    ShaftsRay ray = shafts_ray(start, direction);
    float whole = air ? whole_way(start) : 0.0, power = power_of(start), from = 0.0;
    Scattered first = scattered_at(ray, 0.0);
    keep(ivec3(column, 0), air ? first.even : vec3(0.0), air ? first.peaked / peak : vec3(0.0));
    for (int i = 1; i < size.z; ++i) {
        float to = whole * pow(float(i) / float(size.z - 1), power);
        if (air) {
            Scattered there = scattered_at(ray, 0.5 * (from + to));
            vec3 passed = (to - from) * there.extinction;
            vec3 seen = exp(-depth) * mix((1.0 - exp(-passed)) / max(there.extinction, 1e-12), vec3(to - from), lessThan(passed, vec3(1e-3)));
            even += there.even * seen, peaked += there.peaked / peak * seen;
            depth += passed;
        }
        keep(ivec3(column, i), even / max(to, 1e-3), peaked / max(to, 1e-3));
        from = to;
    }
}
