#version 450 core
// The light of a grid of rays, marched by hillaire2020 between layers: single scattering, and his series for all orders beyond.
#include "air_march.glsl"
#include "physics/phase.glsl"
#include "physics/models/perez.glsl"
#include "physics/models/bruneton2008.glsl"
#include "physics/models/hillaire2020.glsl"
layout(binding = 8) uniform sampler2D medium;
layout(binding = 9) uniform sampler2D transmittance;  // optical depths
layout(binding = 10) uniform sampler2D multiple;
layout(binding = 11) uniform sampler2D phases;  // of air, and the mean of aerosols: even in the root of the scattering angle
layout(std140, binding = 1) uniform HillaireBlock {
    Hillaire2020 sky;
    vec4 solar_irradiance;
    vec4 colour_of_wavelength[4];
};
const int steps = 4;  // between two layers

vec3 colour_of(vec4 light) {
    vec3 sum = vec3(0.0);
    for (int w = 0; w < N; ++w) sum += light[w] * colour_of_wavelength[w].rgb;
    return sum;
}

vec4 phase_of(float row, float angle) {
    return look_up(phases, vec2(texture_coordinate(sqrt(angle / pi), textureSize(phases, 0).x), row));
}

struct Gathered {
    vec4 once, peaks, more, transmittance;
};

Gathered nothing_gathered() { return Gathered(vec4(0.0), vec4(0.0), vec4(0.0), vec4(1.0)); }

void gather(Way way, float from, float to, inout Gathered g) {
    float h = clamp(altitude_at(way.h, way.mu, from, sky.bottom), 0.0, sky.top);
    float mu = cosine_at(way.h, way.mu, from, h, sky.bottom), mu_s = sun_cosine_at(way.h, way.mu_s, way.nu, from, h, sky.bottom);
    vec4 air = phase_of(0.25, way.angle), aerosol = phase_of(0.75, way.angle), none = vec4(0.0);
    // His march sums all light; that of one kind is what is missing without it.
    Hillaire2020Light more = hillaire2020_march(sky, medium, transmittance, multiple, h, mu, mu_s, way.nu, to - from, steps, none, none);
    Hillaire2020Light even = hillaire2020_march(sky, medium, transmittance, multiple, h, mu, mu_s, way.nu, to - from, steps, air, none);
    Hillaire2020Light all = hillaire2020_march(sky, medium, transmittance, multiple, h, mu, mu_s, way.nu, to - from, steps, air, aerosol);
    g.more += g.transmittance * more.inscattered;
    g.once += g.transmittance * (even.inscattered - more.inscattered);
    g.peaks += g.transmittance * (all.inscattered - even.inscattered);
    g.transmittance *= even.transmittance;
}

Colours colours_of(Way way, Gathered g) {
    vec4 taken = 1.0 - g.transmittance;
    vec4 sun = solar_irradiance * step(1e-5, taken);  // a smaller share may be the rounding of forty steps
    return Colours(colour_of(sun * g.once), colour_of(sun * g.peaks), colour_of(sun * g.more), colour_of(sun * taken) / colour_of_sun.rgb);
}

#include "air_march_main.glsl"
