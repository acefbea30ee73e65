// Light along each ray of the grid of air_rays.glsl, up to each layer of places on its way, four wavelengths at a time, which add up to
// colours. A method's text defines between this one and air_march_main.glsl how light is gathered:
//
//   struct Gathered                                               what is known of the way so far
//   Gathered nothing_gathered()
//   void gather(Way way, float from, float to, inout Gathered g)  between two distances from the ray's start
//   Colours colours_of(Way way, Gathered g)
#include "air_rays.glsl"
layout(local_size_x = 8, local_size_y = 2) in;
layout(binding = 0, rgba32f) uniform image3D rays;
layout(binding = 13) uniform sampler2D peak;  // the reference phase function of what has a peak, by peak_coordinate
layout(std430, binding = 5) readonly buffer AirWays {
    vec4 ways[];  // of each row: zenith cosine at the eye, and where the ray enters the air; empty way before it; length in the air, negative
                  // if the ground ends it
};
layout(std140, binding = 6) uniform AirShare {
    ivec4 share;     // 1 in the first and in the last of the groups of wavelengths
    vec4 peaked[2];  // 1 for each constituent whose phase function has a peak
};

// A ray from where it enters the air.
struct Way {
    float h;  // altitude of its start
    float mu, mu_s, nu;
    float extent;
    bool grounded;
    float angle;  // between the ray and the sun
};

// Of the wavelengths at hand: light scattered once without and with a peak, light scattered more often, and the share of the sun's light
// that the way takes.
struct Colours {
    vec3 once, peaks, more, taken;
};

// 1 - e^-depth without cancellation.
vec4 taken_by(vec4 depth) { return mix(1.0 - exp(-depth), depth * (1.0 - depth * (0.5 - depth / 6.0)), lessThan(depth, vec4(0.03))); }
