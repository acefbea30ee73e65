// What the ground reflects, from what covers it or from an image of the planet (src/render/ground_pass.h).
#include "ground_detail.glsl"
const int grass = 0, steppe = 1, sand = 2, rock = 3, snow = 4, sea = 5;
layout(std140, binding = 1) uniform Ground {
    vec4 ground_reflectance[6];  // and contrast
    vec4 ground_tint[6];         // and relief
    vec4 ground_facts;  // 1 if what lies below 0 m is under water; a pixel of the image from north to south, in metres, or 0; the widest octave
};
layout(binding = 4) uniform sampler2D ground_image;

// What covers the ground, in patches: nothing becomes more or less in the mean.
vec4 cover_in_patches(vec4 cover, Detail detail) {
    const float sharpness = 0.8;
    return cover + min(cover, 1.0 - cover) * clamp(sharpness * vec4(detail.patches, detail.slope.zxy), -1.0, 1.0);
}

// How much of a material's colour is seen at a place: 1 in the mean.
vec3 variation(int kind, Detail detail) {
    return 1.0 + ground_reflectance[kind].w * clamp(detail.grain, -2.5, 2.5) + ground_tint[kind].rgb * clamp(detail.slope.z, -2.5, 2.5);
}

// Of steppe, sand, rock and snow over grass, in this order.
vec3 covered_reflectance(vec4 cover, Detail detail) {
    vec3 sum = ground_reflectance[grass].rgb * variation(grass, detail);
    for (int kind = steppe; kind <= snow; ++kind)
        sum = mix(sum, ground_reflectance[kind].rgb * variation(kind, detail), cover[kind - steppe]);
    return sum;
}

// The same of ground whose colours an image holds.
vec3 covered_variation(vec4 cover, Detail detail) {
    vec3 sum = variation(grass, detail);
    for (int kind = steppe; kind <= snow; ++kind) sum = mix(sum, variation(kind, detail), cover[kind - steppe]);
    return sum;
}

// Of the image, in a direction from the planet's centre; a pixel of the picture is `footprint_m` wide there. Its own level is chosen, for
// coordinates jump where the image's ends meet.
vec3 image_reflectance(vec3 direction, float footprint_m) {
    const float pi = 3.14159265358979;
    vec2 place = vec2(0.5 + atan(direction.y, direction.x) / (2.0 * pi), 0.5 - atan(direction.z, length(direction.xy)) / pi);
    return textureLod(ground_image, place, log2(footprint_m / ground_facts.y)).rgb;
}

// The colour of the ground, and of the sea where there is water; `there`: what covers it in patches.
vec3 reflectance_of(vec4 there, Detail detail, float water, vec3 position, float footprint_m) {
    if (ground_facts.y > 0.0) {
        vec3 image = image_reflectance(normalize(vec3(camera_eye_m.xyz) + position), footprint_m);
        return image * mix(covered_variation(there, detail), vec3(1.0), water);
    }
    return mix(covered_reflectance(there, detail), ground_reflectance[sea].rgb, water);
}

// A normal turned by slopes that are given along the axes of the world: what of them is along the surface, by Gram and Schmidt's step
// [Mikkelsen2010]. No tangents are asked for, which nowhere on a sphere can be continuous everywhere.
vec3 sloped(vec3 normal, vec3 slope) { return normalize(normal - (slope - dot(slope, normal) * normal)); }

// By what covers the ground at large: patches follow slopes, and would tilt the ground in the mean.
vec3 normal_of(vec3 normal, vec4 cover, Detail detail) {
    float relief = ground_tint[grass].w;
    for (int kind = steppe; kind <= snow; ++kind) relief = mix(relief, ground_tint[kind].w, cover[kind - steppe]);
    return sloped(normal, relief * detail.bumps);
}
