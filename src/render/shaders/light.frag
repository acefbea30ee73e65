#version 450 core
// The light of the sun and of an even sky on what the geometry buffer holds, without air.
#include "camera.glsl"
#include "octahedral.glsl"
layout(binding = 0) uniform sampler2D depth_buffer;
layout(binding = 1) uniform sampler2D colour_buffer;
layout(binding = 2) uniform sampler2D normal_buffer;
layout(binding = 3) uniform sampler2D material_buffer;
layout(std140, binding = 2) uniform Lights {
    vec4 towards_sun;  // of length one
    vec4 sun;          // irradiance on a surface that faces it
    vec4 sky;          // irradiance from above
};
layout(location = 0) in vec2 place;
layout(location = 0) out vec4 radiance;

const float pi = 3.14159265358979;
const float mirror_of_water = 0.02;  // reflectance of still water at right angles

// The sun in water whose waves tilt as a Gaussian of their slope does, with a mean square of roughness^2 / 2 [CoxMunk1954].
float glint(vec3 n, vec3 view, float roughness) {
    vec3 between = normalize(towards_sun.xyz + view);
    float c = clamp(dot(n, between), 1e-2, 1.0), m = roughness * roughness;
    float slopes = exp((1.0 - 1.0 / (c * c)) / m) / (pi * m * c * c * c * c);
    float fresnel = mirror_of_water + (1.0 - mirror_of_water) * pow(1.0 - clamp(dot(view, between), 0.0, 1.0), 5.0);
    return fresnel * slopes / (4.0 * max(dot(n, view), 0.05));
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 colour = texelFetch(colour_buffer, pixel, 0);
    if (colour.a == 0.0) {
        radiance = vec4(0.0);
        return;
    }
    vec3 n = from_octahedral(texelFetch(normal_buffer, pixel, 0).rg);
    vec2 material = texelFetch(material_buffer, pixel, 0).rg;
    vec3 position = position_at(place, texelFetch(depth_buffer, pixel, 0).r);
    vec3 up = normalize(vec3(camera_eye_m.xyz + dvec3(position)));
    float day = smoothstep(-0.05, 0.05, dot(up, towards_sun.xyz));
    float facing = max(dot(n, towards_sun.xyz), 0.0) * day;
    vec3 light = colour.rgb / pi * (sun.rgb * facing + sky.rgb * day * (0.5 + 0.5 * dot(n, up)));
    if (facing > 0.0) light += material.g * sun.rgb * day * glint(n, -normalize(position), material.r);
    radiance = vec4(light, 1.0);
}
