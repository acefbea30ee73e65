// What the air scatters once towards the eye, from each place of a ray: red, green and blue (src/render/shafts_air.h). The unit is the
// irradiance of the sun above the air in each channel, m-1 sr-1.
#include "air_view.glsl"
#include "physics/maps.glsl"
layout(binding = 8) uniform sampler2D profiles;   // by altitude: extinction in the first row, then what each constituent scatters
layout(binding = 9) uniform sampler2D phases;     // of each constituent, even in the root of the scattering angle; alpha: 1 if it has a peak;
                                                  // in the last row the sum of those that have
layout(binding = 10) uniform sampler2D sun_depth; // optical depths towards the sun, by altitude and zenith cosine
const int most_parts = 12;

// A ray from the eye, and what its angle from the sun makes of each constituent.
struct ShaftsRay {
    AirRay start;
    int parts;
    vec4 phase[most_parts];
};

// A row of `phases` for a direction.
vec4 phase_in_row(int row, vec3 direction) {
    ivec2 size = textureSize(phases, 0);
    float u = texture_coordinate(sqrt(angle_between(direction, towards_sun.xyz) / pi), size.x);
    return textureLod(phases, vec2(u, (float(row) + 0.5) / float(size.y)), 0.0);
}

// Phase functions that have a peak are read for each pixel: what else there is of light is smooth, and kept in a small table.
vec3 peak_towards(vec3 direction) { return phase_in_row(textureSize(phases, 0).y - 1, direction).rgb; }

ShaftsRay shafts_ray(AirRay start, vec3 direction) {
    ShaftsRay ray;
    ray.start = start;
    ray.parts = textureSize(phases, 0).y - 1;
    for (int p = 0; p < ray.parts; ++p) ray.phase[p] = phase_in_row(p, direction);
    return ray;
}

float sun_above(float h, float mu_s) {
    float horizon = horizon_cosine(h, air_shell.x), sine = sqrt(max(1.0 - horizon * horizon, 1e-6));
    return clamp(0.5 + 0.5 * (mu_s - horizon) / (sine * max(towards_sun.w, 1e-5)), 0.0, 1.0);
}

// What is scattered at a distance from a ray's start, before the air between dims it.
struct Scattered {
    vec3 even, peaked;  // by what has no peak, and by what has one
    vec3 extinction;    // there
};

// Below the ground sphere the air is that of the ground.
Scattered scattered_at(ShaftsRay ray, float way) {
    float bottom = air_shell.x, top = air_shell.y;
    float h = altitude_at(ray.start.h, ray.start.mu, way, bottom);
    Scattered light = Scattered(vec3(0.0), vec3(0.0), vec3(0.0));
    if (h > top) return light;
    h = max(h, 0.0);
    float mu_s = sun_cosine_at(ray.start.h, ray.start.mu_s, ray.start.nu, way, h, bottom);
    float u = texture_coordinate(altitude_coordinate(h, top), textureSize(profiles, 0).x), row = 1.0 / float(textureSize(profiles, 0).y);
    light.extinction = textureLod(profiles, vec2(u, 0.5 * row), 0.0).rgb;
    for (int p = 0; p < ray.parts; ++p) {
        vec3 scattered = textureLod(profiles, vec2(u, (float(p) + 1.5) * row), 0.0).rgb * ray.phase[p].rgb;
        if (ray.phase[p].a > 0.0) light.peaked += scattered;
        else light.even += scattered;
    }
    vec2 at = vec2(transmittance_cosine_coordinate(h, max(mu_s, horizon_cosine(h, bottom)), bottom, top), altitude_coordinate(h, top));
    vec2 size = vec2(textureSize(sun_depth, 0));
    vec3 sunlight = sun_above(h, mu_s) * exp(-textureLod(sun_depth, 0.5 / size + at * (1.0 - 1.0 / size), 0.0).rgb);
    light.even *= sunlight, light.peaked *= sunlight;
    return light;
}
