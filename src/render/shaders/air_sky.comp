#version 450 core
// The sky of an eye in the air, at the ends of the ways that were marched (air_lookup.glsl), for water to mirror.
#include "air_lookup.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba32f) uniform writeonly image2D kept_sky;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(kept_sky);
    if (texel.x >= ray_counts.y || texel.y >= size.y) return;
    float h = ray_eye.x, mu = cosine_of_sky_row(float(texel.y), size.y);
    RayLight light = RayLight(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(1.0));
    if (h < air_shell.y) {
        float length = max(distance_to_top(h, mu, air_shell.x, air_shell.y), 1e-3);
        light = light_at(float(texel.x), row_of(mu, false), length, length, false);
    }
    imageStore(kept_sky, texel, vec4(light.even, 0.0));
    imageStore(kept_sky, texel + ivec2(size.x / 2, 0), vec4(light.peaked, 0.0));
}
