// The rays along which the method `airlight` keeps the light of a frame (src/render/air_rays.h), and the places on them: a column of
// texels for each azimuth from the sun and each row of view zenith angles, a layer for each place on the way.
#include "air_view.glsl"
#include "physics/maps.glsl"
const int air_most_segments = 10;
layout(std140, binding = 4) uniform AirRays {
    ivec4 ray_counts;                    // segments, azimuths, rows; layers beyond the first
    vec4 ray_eye;                        // of the settled eye: altitude and distance of the horizon; share of layers that crowd far off; cosine of the sun's zenith angle
    vec4 segments[air_most_segments];    // zenith angles between which rows are interpolated, first row, how many
};

// A place of a row on the ground, half by the logarithm of its distance and half by the angle (src/sky/dome_rows.cpp).
float place_on_ground(float zenith, float mu) {
    vec4 ground = segments[ray_counts.x - 1];
    float h = ray_eye.x, farthest = ray_eye.y;
    float distance = distance_to_ground(h, mu, air_shell.x);
    return 0.5 * log(farthest / distance) / log(farthest / h) + 0.5 * (zenith - ground.x) / (ground.y - ground.x);
}

// The row, as a real number, of a view whose zenith angle has the cosine mu.
float row_of(float zenith, float mu, bool grounded) {
    vec4 s = segments[ray_counts.x - 1];
    float place = 0.0;
    if (grounded) place = place_on_ground(zenith, mu);
    else {
        s = segments[0];
        for (int i = 1; i < ray_counts.x - 1; ++i)
            if (zenith > segments[i].x) s = segments[i];
        float t = clamp((zenith - s.x) / (s.y - s.x), 0.0, 1.0);
        place = s.x == 0.0 ? 1.0 - sqrt(1.0 - t) : 2.0 / pi * asin(sqrt(t));
    }
    return s.z + clamp(place, 0.0, 1.0) * (s.w - 1.0);
}

// Where layers lie along the way: from 0 at the start of a ray of some length to 1 at its end. They crowd where air is dense: towards
// a low eye, and towards the ground that a high eye sees.
float layer_place(float way, float length, bool grounded) {
    float scale = 0.02 * air_shell.y;
    float near = log(1.0 + way / scale) / log(1.0 + length / scale);
    float far = grounded ? 1.0 - log(1.0 + max(length - way, 0.0) / scale) / log(1.0 + length / scale) : way / length;
    return mix(near, far, ray_eye.z);
}
// The derivative of that place by the way.
float layer_slope(float way, float length, bool grounded) {
    float scale = 0.02 * air_shell.y, whole = log(1.0 + length / scale);
    float near = 1.0 / ((scale + way) * whole);
    float far = grounded ? 1.0 / ((scale + max(length - way, 0.0)) * whole) : 1.0 / length;
    return mix(near, far, ray_eye.z);
}
