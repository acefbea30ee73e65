// What stands above the air (src/render/background_pass.h).
#include "physics/readings/glsl.glsl"
#include "physics/shell.glsl"
#include "angle.glsl"
layout(std140, binding = 1) uniform Background {
    vec4 eye_up;           // away from the planet's centre, of length one; elevation of the lowest ray that misses the ground, in radians
    vec4 towards_sun;      // of length one; angular radius of the disk
    vec4 sun_radiance[3];  // of 1, minus the factors of 1 - mu and of its square
    vec4 towards_moon;     // of length one; angular radius, 0: there is no moon
    vec4 moon_to_sun;      // of length one
    vec4 moon_lit;         // radiance of the moon where the sun stands as high as the eye
    vec4 moon_dark;        // its radiance by the Earth's light
    vec4 pixel;            // its size in radians in the middle of the picture; how many of them across and up
    vec4 beyond;           // radiance between the stars
    vec4 airglow;          // radiance of the glowing shell of air where it is crossed upright, 0: nothing glows
    vec4 glowing_shell;    // radius of the ground, altitudes of the shell's ends and of the eye
};
// How much lower than it is seen something stands; even in the fourth root of the elevation above the lowest ray.
layout(binding = 0) uniform sampler2D bending;

float elevation_of(vec3 direction) { return atan(dot(direction, eye_up.xyz), length(cross(direction, eye_up.xyz))); }

float bending_at(float elevation) {
    float u = sqrt(sqrt(clamp((elevation - eye_up.w) / (0.5 * pi - eye_up.w), 0.0, 1.0))), texels = float(textureSize(bending, 0).x);
    return textureLod(bending, vec2((u * (texels - 1.0) + 0.5) / texels, 0.5), 0.0).r;
}

// A direction of length one turned towards the zenith by an angle.
vec3 raised(vec3 direction, float angle) {
    float up = dot(direction, eye_up.xyz), level = length(cross(direction, eye_up.xyz));
    return level > 1e-6 ? direction * cos(angle) + (eye_up.xyz - direction * up) * (sin(angle) / level) : direction;
}
