// What every method of air is told of a frame (src/render/air_pass.h). Textures of a method stand at bindings from 8 on, its uniform
// blocks at 1 and from 3 on.
#include "physics/readings/glsl.glsl"
#include "physics/shell.glsl"
#include "angle.glsl"
layout(std140, binding = 2) uniform AirView {
    vec4 eye_up;             // away from the planet's centre, of length one; the eye's altitude
    vec4 towards_sun;        // of length one; the angular radius of the sun's disk
    vec4 air_shell;          // radius of the ground, altitude of the top; 1 if the background is seen, else 0
    vec4 colour_of_sun;      // of its light above the air, on a surface that faces it
    vec4 limb_darkening[2];  // in each colour
    vec4 ground_albedo;      // of the ground sphere
    vec4 moon;               // from the eye; its radius, 0 where it takes no sunlight from the planet
    vec4 eclipse;            // inverse of the sun's distance; radius of the moon's disk over the sun's, at the table's first and last row
    vec4 night_scattered;    // radiance of air that lets nothing through, by the light between the stars
    vec4 night_illuminance;  // of level ground by that light
};

// The part within the air of a ray from the eye.
struct AirRay {
    float h;      // altitude of its start
    float mu;     // zenith cosines of the ray and of the sun there
    float mu_s;
    float nu;     // cosine between ray and sun
    float empty;  // distance of its start from the eye
};

// False if the ray does not meet the air.
bool enter_air(vec3 direction, out AirRay ray) {
    vec3 up = eye_up.xyz;
    float bottom = air_shell.x, top = air_shell.y;
    ray = AirRay(max(eye_up.w, 0.0), dot(direction, up), dot(up, towards_sun.xyz), dot(direction, towards_sun.xyz), 0.0);
    if (ray.h <= top) return true;
    float r = bottom + ray.h, r_top = bottom + top;
    float beside = r * length(cross(direction, up));  // how far from the centre it passes
    float inside = (r_top - beside) * (r_top + beside);
    if (ray.mu >= 0.0 || inside <= 0.0) return false;
    float way = (ray.h - top) * (r + r_top) / (sqrt(inside) - r * ray.mu);
    ray = AirRay(top, -sqrt(inside) / r_top, clamp((r * ray.mu_s + ray.nu * way) / r_top, -1.0, 1.0), ray.nu, way);
    return true;
}

// What the moon covers of the sun: src/render/eclipse_table.h.
layout(binding = 5) uniform sampler2D covered_sun;

// The part of the sun's light that is left. Distance between disks, and their radii, in radians.
vec4 sunlight_left(float separation, float sun, float moon_radius, vec4 dark_1, vec4 dark_2) {
    float inner = max(abs(moon_radius - sun), 1e-9), outer = moon_radius + sun;
    float u = separation < inner ? 0.25 * separation / inner : 0.25 + 0.75 * sqrt(min((separation - inner) / (outer - inner), 1.0));
    vec2 at = vec2(u, (moon_radius / sun - eclipse.y) / (eclipse.z - eclipse.y)), texels = vec2(textureSize(covered_sun, 0));
    vec3 covered = textureLod(covered_sun, (at * (texels - 1.0) + 0.5) / texels, 0.0).rgb;
    return max(1.0 - (covered.r + dark_1 * covered.g + dark_2 * covered.b) / (1.0 - dark_1 / 3.0 - dark_2 / 6.0), 0.0);
}

// The parts of light that pass the moon.
struct Passing {
    vec4 sun;  // of the sun's own
    vec4 sky;  // of what has been scattered more than once
};

// To a point relative to the eye, in colours whose limb darkening is given. A little of the sky's light comes from around, and is all there is within the umbra: the two numbers
// make the zenith in totality 10^-4 of the day's, as it was measured [DandekarTurtle1971].
Passing light_passing(vec3 point, vec4 dark_1, vec4 dark_2) {
    const float around_m = 150e3, from_around = 0.15;
    if (moon.w == 0.0) return Passing(vec4(1.0), vec4(1.0));
    vec3 to_moon = moon.xyz - point, to_sun = normalize(towards_sun.xyz - point * eclipse.x);
    float distance_m = length(to_moon), separation = angle_between(to_moon / distance_m, to_sun);
    vec4 here = sunlight_left(separation, towards_sun.w, moon.w / distance_m, dark_1, dark_2);
    vec4 around = sunlight_left(separation + around_m / distance_m, towards_sun.w, moon.w / distance_m, dark_1, dark_2);
    return Passing(here, mix(here, around, from_around));
}

// To the air before a place, on average: by how dense it is, and by how much of its light comes through. For methods whose light knows no
// moon; the density falls by e in 8 km, near the ground light does so in 60 km.
Passing air_passing(vec3 direction, float distance_m) {
    AirRay ray;
    if (moon.w == 0.0 || !enter_air(direction, ray)) return Passing(vec4(1.0), vec4(1.0));
    bool grounded = meets_ground(ray.h, ray.mu, air_shell.x);
    float end = grounded ? distance_to_ground(ray.h, ray.mu, air_shell.x) : distance_to_top(ray.h, ray.mu, air_shell.x, air_shell.y);
    float way = clamp(distance_m - ray.empty, 1.0, end), depth = 0.0, sum = 0.0, before = 0.0;
    Passing mean = Passing(vec4(0.0), vec4(0.0));
    const int pieces = 16;
    for (int i = 1; i <= pieces; ++i) {
        float x = float(i) / float(pieces), after = way * (grounded ? 1.0 - (1.0 - x) * (1.0 - x) : x * x);
        float middle = 0.5 * (before + after), air_m = (after - before) * exp(-altitude_at(ray.h, ray.mu, middle, air_shell.x) / 8e3);
        float weight = max(air_m, 1e-6) * exp(-(depth + 0.5 * air_m) / 60e3);
        Passing there = light_passing(direction * (ray.empty + middle), limb_darkening[0], limb_darkening[1]);
        mean.sun += weight * there.sun, mean.sky += weight * there.sky;
        sum += weight, depth += air_m, before = after;
    }
    return Passing(mean.sun / sum, mean.sky / sum);
}
