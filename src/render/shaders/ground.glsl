// What the ground reflects, from what covers it or from an image of the planet (src/render/ground_textures.h).
const int grass = 0, steppe = 1, sand = 2, rock = 3, snow = 4, sea = 5;
layout(std140, binding = 2) uniform Ground {
    vec4 ground_reflectance[6];
    vec4 ground_wishes;  // 1 if what lies below 0 m is under water; a pixel of the image from north to south, in metres, or 0
};
layout(binding = 0) uniform sampler2D ground_image;

// Of steppe, sand, rock and snow over grass, in this order.
vec3 covered_reflectance(vec4 cover) {
    vec3 sum = ground_reflectance[grass].rgb;
    for (int kind = steppe; kind <= snow; ++kind) sum = mix(sum, ground_reflectance[kind].rgb, cover[kind - steppe]);
    return sum;
}

// Of the image, in a direction from the planet's centre; a pixel of the picture is `footprint_m` wide there. Its own level is chosen, for
// coordinates jump where the image's ends meet.
vec3 image_reflectance(vec3 direction, float footprint_m) {
    const float pi = 3.14159265358979;
    vec2 place = vec2(0.5 + atan(direction.y, direction.x) / (2.0 * pi), 0.5 - atan(direction.z, length(direction.xy)) / pi);
    return textureLod(ground_image, place, log2(footprint_m / ground_wishes.y)).rgb;
}
