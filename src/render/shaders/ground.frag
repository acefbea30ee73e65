#version 450 core
// The looks of the ground and the sea, of what terrain.frag has left in the geometry buffer.
#include "camera.glsl"
#include "geometry_buffer.glsl"
#include "ground.glsl"
layout(binding = 0) uniform sampler2D depth_buffer;
layout(binding = 1) uniform sampler2D colour_buffer;
layout(binding = 2) uniform sampler2D normal_buffer;
layout(binding = 3) uniform sampler2D material_buffer;
layout(location = 0) in vec2 place;

const float rough_land = 1.0;
const float slopes_of_sea = 0.04;  // their mean square, in a wind of 7 m/s [CoxMunk1954]
const float rounding = 1e-6;  // of a position rebuilt from depth, as a share of its distance: nothing finer is looked at through a telescope
const float nothing_seen = 1e9;  // a pixel's width: loops over no octaves end at once, where drivers may run both sides of a branch

// How wide a pixel is on the ground: between its width and its length, which on ground that is seen at a low angle are far apart.
float footprint_m(vec3 position, vec3 normal) {
    float distance_m = length(position), width_m = distance_m * 2.0 * camera_lens.y / float(textureSize(depth_buffer, 0).y);
    float facing = max(-dot(position, normal) / distance_m, 0.02);
    return max(width_m * max(inversesqrt(facing), 0.5 / facing), rounding * distance_m);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 colour = texelFetch(colour_buffer, pixel, 0);
    if (abs(colour.a - alpha_of_cover) > 0.1) discard;
    vec2 material = texelFetch(material_buffer, pixel, 0).rg;
    vec3 normal = from_octahedral(texelFetch(normal_buffer, pixel, 0).rg);
    vec3 position = position_at(place, texelFetch(depth_buffer, pixel, 0).r);
    float water = ground_facts.x * material.g;
    float footprint = footprint_m(position, normal);
    Detail detail = detail_at(position, water < 1.0 ? footprint : nothing_seen, int(ground_facts.z));
    vec4 cover = vec4(colour.r, material.r, colour.gb), there = cover_in_patches(cover, detail);
    vec3 reflectance = reflectance_of(there, detail, water, position, footprint);
    normal = normal_of(normal, cover, detail);
    float roughness = rough_land;
    if (water > 0.0) {
        vec3 up = normalize(vec3(camera_eye_m.xyz) + position);
        Waves waves = waves_at(position, water > 0.0 ? footprint : nothing_seen, slopes_of_sea);
        normal = normalize(mix(normal, sloped(up, waves.slope), water));
        roughness = sqrt(slopes_of_sea * (1.0 - waves.share));  // what of the pixel is land does not shine
    }
    write_surface(reflectance, normal, roughness, water);
}
