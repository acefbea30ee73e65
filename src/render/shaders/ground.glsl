// What the ground reflects, from what covers it or from an image of the planet (src/render/ground_pass.h).
#include "ground_detail.glsl"
const int grass = 0, steppe = 1, sand = 2, rock = 3, snow = 4, sea = 5;
layout(std140, binding = 1) uniform Ground {
    vec4 ground_reflectance[6];  // and contrast
    vec4 ground_tint[6];
    vec4 ground_wishes;  // 1 if what lies below 0 m is under water; a pixel of the image from north to south, in metres, or 0; the widest octave
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
    return textureLod(ground_image, place, log2(footprint_m / ground_wishes.y)).rgb;
}

// Of the ground, and of the sea where there is water.
vec3 reflectance_of(vec4 cover, float water, vec3 place, float footprint_m) {
    Detail detail = Detail(0.0, 0.0, vec3(0.0));
    if (water < 1.0) detail = detail_at(place, footprint_m, int(ground_wishes.z));
    vec4 there = cover_in_patches(cover, detail);
    if (ground_wishes.y > 0.0) {
        vec3 image = image_reflectance(normalize(vec3(camera_eye_m.xyz) + place), footprint_m);
        return image * mix(covered_variation(there, detail), vec3(1.0), water);
    }
    return mix(covered_reflectance(there, detail), ground_reflectance[sea].rgb, water);
}
