#version 450 core
// The shade of each pixel: of the light that the air scatters once towards the eye, the share that stays, between those of the rays around
// that go about as far [KopfEtAl2007]; in alpha, the share of the sun's light that reaches the pixel's surface.
#include "camera.glsl"
#include "shadow.glsl"
layout(binding = 0) uniform sampler2D depth_buffer;
layout(binding = 11) uniform sampler2D lit_rays;
layout(std140, binding = 6) uniform ShaftsRays { ivec4 pixels_of_ray; };
layout(location = 0) in vec2 place;
layout(location = 0) out vec4 shade;

vec3 lit_before(float distance_m) {
    ivec2 pixel = ivec2(gl_FragCoord.xy), ray = pixel / pixels_of_ray.x, last = textureSize(lit_rays, 0) - 1;
    vec2 beyond = vec2(pixel - ray * pixels_of_ray.x) / float(pixels_of_ray.x);
    if (beyond == vec2(0.0)) return texelFetch(lit_rays, ray, 0).rgb;
    vec4 sum = vec4(0.0);
    for (int k = 0; k < 4; ++k) {
        ivec2 corner = ivec2(k & 1, k >> 1);
        vec4 around = texelFetch(lit_rays, min(ray + corner, last), 0);
        vec2 share = mix(1.0 - beyond, beyond, vec2(corner));
        float farther = around.a - log(distance_m);
        sum += share.x * share.y / (0.01 + farther * farther) * vec4(around.rgb, 1.0);
    }
    return sum.rgb / sum.a;
}

void main() {
    float depth = texelFetch(depth_buffer, ivec2(gl_FragCoord.xy), 0).r;
    vec3 position = depth > 0.0 ? position_at(place, depth) : vec3(0.0);
    shade = vec4(lit_before(depth > 0.0 ? length(position) : 1e30), depth > 0.0 ? sun_visibility(position) : 1.0);
}
