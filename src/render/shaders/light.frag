#version 450 core
// The light of the sun and of an even sky on what the geometry buffer holds, without air.
#include "camera.glsl"
#include "octahedral.glsl"
const float pi = 3.14159265358979;
#include "surface_light.glsl"
layout(binding = 0) uniform sampler2D depth_buffer;
layout(binding = 1) uniform sampler2D colour_buffer;
layout(binding = 2) uniform sampler2D normal_buffer;
layout(binding = 3) uniform sampler2D material_buffer;
layout(binding = 4) uniform sampler2D background_buffer;
layout(binding = 7) uniform sampler2D shade_buffer;  // src/render/shafts_pass.h
layout(std140, binding = 2) uniform Lights {
    vec4 towards_sun;  // of length one
    vec4 sun;          // irradiance on a surface that faces it
    vec4 sky;          // irradiance from above; 1 if there is a background, else 0
};
layout(location = 0) in vec2 place;
layout(location = 0) out vec4 radiance;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 colour = texelFetch(colour_buffer, pixel, 0);
    if (colour.a == 0.0) {
        radiance = sky.w > 0.0 ? vec4(texelFetch(background_buffer, pixel, 0).rgb, 0.0) : vec4(0.0);
        return;
    }
    vec3 n = from_octahedral(texelFetch(normal_buffer, pixel, 0).rg);
    vec2 material = texelFetch(material_buffer, pixel, 0).rg;
    vec3 position = position_at(place, texelFetch(depth_buffer, pixel, 0).r);
    vec3 up = normalize(vec3(camera_eye_m.xyz + dvec3(position)));
    float day = smoothstep(-0.05, 0.05, dot(up, towards_sun.xyz));
    SurfaceLight light = surface_light(colour.rgb, material, n, up, -normalize(position), towards_sun.xyz);
    if (material.g > 0.0) light.of_sky += material.g * mirror_of(n, up, -normalize(position), material.r).share / pi;
    float sunlit = textureLod(shade_buffer, 0.5 * place + 0.5, 0.0).a;
    radiance = vec4(day * (sunlit * sun.rgb * light.of_sun + sky.rgb * light.of_sky), 1.0);
}
