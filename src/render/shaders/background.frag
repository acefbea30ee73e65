#version 450 core
// The disks of the sun and the moon, the sun's corona, and the light between the stars.
#include "camera.glsl"
#include "background.glsl"
#include "night_sky.glsl"
layout(location = 0) in vec2 place;
layout(location = 0) out vec4 radiance;

// The part of a pixel that a disk covers: it rises from 0 to 1 over `width`, what a pixel is wide in angles from the disk's centre.
float covered(float angle, float radius, float width) { return clamp((radius - angle) / width + 0.5, 0.0, 1.0); }

vec3 sun_at(float angle, float width) {
    float radius = towards_sun.w, s = min(angle / radius, 1.0), dark = 1.0 - sqrt(1.0 - s * s);
    vec3 disk = sun_radiance[0].rgb - sun_radiance[1].rgb * dark - sun_radiance[2].rgb * (dark * dark);
    // Of a sun smaller than a pixel, its light is spread over the pixel.
    vec3 seen = disk * covered(angle, radius, width) * min(1.0, pi * radius * radius / (pixel.x * pixel.x));
    // Baumbach's law of the corona, over the brightness of the disk's middle [Cox2000, sec. 14.9], as far as it was measured.
    float r = max(angle / radius, 1.0), r2 = r * r, r6 = r2 * r2 * r2;
    float corona = 1e-6 * (0.0532 / (r2 * sqrt(r)) + 1.425 / (r6 * r) + 2.565 / (r6 * r6 * r2 * r2 * r));
    return max(seen, sun_radiance[0].rgb * (corona * (1.0 - smoothstep(6.0, 20.0, r))));
}

// Lommel and Seeliger's law over a ball, and the Earth's light.
vec3 moon_at(vec3 direction) {
    vec3 offset = (direction - towards_moon.xyz * dot(direction, towards_moon.xyz)) / sin(towards_moon.w);
    offset /= max(length(offset), 1.0);  // beyond the limb, where a pixel is partly covered, it is the limb
    float mu = sqrt(max(1.0 - dot(offset, offset), 0.0)), mu_0 = dot(offset - towards_moon.xyz * mu, moon_to_sun.xyz);
    return moon_dark.rgb + (mu_0 > 0.0 ? moon_lit.rgb * (2.0 * mu_0 / (mu_0 + mu)) : vec3(0.0));
}

// Whether a disk may be seen within some of its radii from a direction, however air bends (by 0.02 at most) and pixels are wide.
bool may_be_near(vec3 apparent, vec4 disk, float radii) { return dot(apparent, disk.xyz) > cos(radii * disk.w + 0.03 + 2.0 * pixel.x); }

void main() {
    vec3 apparent = normalize(view_ray(place)), night = night_sky_at(apparent);
    radiance = vec4(night, 1.0);
    if (!may_be_near(apparent, towards_sun, 20.0) && !may_be_near(apparent, towards_moon, 1.0)) return;
    float elevation = elevation_of(apparent);
    vec3 direction = raised(apparent, -bending_at(elevation));
    float from_sun = angle_between(direction, towards_sun.xyz), from_moon = angle_between(direction, towards_moon.xyz);
    float sun_width = max(length(vec2(dFdx(from_sun), dFdy(from_sun))), 1e-7);
    float moon_width = max(length(vec2(dFdx(from_moon), dFdy(from_moon))), 1e-7);
    vec3 sum = night;
    if (elevation >= eye_up.w && from_sun < 20.0 * towards_sun.w) sum += sun_at(from_sun, sun_width);
    if (elevation >= eye_up.w && towards_moon.w > 0.0) {
        float part = covered(from_moon, towards_moon.w, moon_width);
        if (part > 0.0) sum = mix(sum, moon_at(direction), part);
    }
    radiance.rgb = sum;
}
