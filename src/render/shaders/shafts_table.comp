#version 450 core
// One column of the table of light scattered once.
#include "camera.glsl"
#include "shafts_table.glsl"
layout(local_size_x = 8, local_size_y = 6) in;
layout(binding = 0, rgba32f) uniform writeonly image3D table;

void main() {
    ivec3 size = imageSize(table);
    ivec2 column = ivec2(gl_GlobalInvocationID.xy);
    vec3 direction = normalize(view_ray(vec2(column) / vec2(size.xy - 1) * 2.0 - 1.0));
    vec3 depth = vec3(0.0), sum = vec3(0.0);
    imageStore(table, ivec3(column, 0), vec4(0.0));
    AirRay start;
    if (!enter_air(direction, start)) {
        for (int i = 1; i < size.z; ++i) imageStore(table, ivec3(column, i), vec4(0.0));
        return;
    }
    ShaftsRay ray = shafts_ray(start, direction);
    float whole = whole_way(start), power = power_of(start), from = 0.0;
    for (int i = 1; i < size.z; ++i) {
        float to = whole * pow(float(i) / float(size.z - 1), power);
        vec3 extinction, light = scattered_at(ray, 0.5 * (from + to), extinction);
        vec3 passed = (to - from) * extinction;
        sum += light * exp(-depth) * mix((1.0 - exp(-passed)) / max(extinction, 1e-12), vec3(to - from), lessThan(passed, vec3(1e-3)));
        depth += passed;
        imageStore(table, ivec3(column, i), vec4(sum, 0.0));
        from = to;
    }
}
