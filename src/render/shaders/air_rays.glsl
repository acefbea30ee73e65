// The rays along which the method `airlight` keeps the light of a frame (src/render/air_ray_grid.h), and the places on them: a column of
// texels for each azimuth from the sun and each row of view zenith angles, a layer for each place on the way.
#include "air_view.glsl"
#include "physics/angle.glsl"
#include "physics/maps.glsl"
const int most_sky_segments = 9;
layout(std140, binding = 4) uniform AirRays {
    ivec4 ray_counts;  // first row of the ground; azimuths, rows; layers beyond the first
    vec4 ray_eye;      // of the settled eye: altitude; share of layers that crowd far off; cosine of the sun's zenith angle
    vec4 ray_ground;   // logarithm of the horizon's distance, part of the rows for a logarithm; zenith angle of the horizon, part for an angle
    vec4 sky_segments[most_sky_segments];  // zenith angles between which rows are interpolated, first row, how many; unused ones below the nadir
};

// What is known of a place, side by side in one texture: radiance, over the share of light that the way takes, of what has no peak, over a
// scale, and the logarithm of that scale; the same of what has a peak, over the same and over the reference phase function; the mean
// extinction along the way; of the first, the share that was scattered once.
const int ray_smooth = 0, ray_peaked = 1, ray_extinction = 2, ray_once = 3, ray_parts = 4;

// A place of a row on the ground, half by the logarithm of its distance and half by the angle (src/sky/dome_rows.cpp).
float place_on_ground(float zenith, float mu) {
    float distance = distance_to_ground(ray_eye.x, mu, air_shell.x);
    return (ray_ground.x - log(distance)) * ray_ground.y + (zenith - ray_ground.z) * ray_ground.w;
}

// The column, as a real number, of a view: from cosines of zenith angles of the view and the sun, and of the angle between them.
float column_of(float mu, float mu_s, float nu) {
    return azimuth_coordinate(relative_azimuth_cosine(mu, mu_s, nu)) * float(ray_counts.y - 1);
}

// The row, as a real number, of a view whose zenith angle has the cosine mu.
float row_of(float mu, bool grounded) {
    float zenith = angle_of_cosine(mu);
    vec4 s = sky_segments[0];
    for (int i = 1; i < most_sky_segments; ++i) s = mix(s, sky_segments[i], bvec4(zenith > sky_segments[i].x));
    float t = clamp((zenith - s.x) / (s.y - s.x), 0.0, 1.0);
    float sky = s.z + (s.x == 0.0 ? 1.0 - sqrt(1.0 - t) : 2.0 / pi * asin(sqrt(t))) * (s.w - 1.0);
    float ground = float(ray_counts.x) + clamp(place_on_ground(zenith, mu), 0.0, 1.0) * float(ray_counts.z - 1 - ray_counts.x);
    return grounded ? ground : sky;
}

// The row, as a real number, of what is kept of the ends of ways into the sky: they crowd towards the horizontal.
float sky_row(float mu, int rows) { return sqrt(max(mu, 0.0)) * float(rows - 1); }
float cosine_of_sky_row(float row, int rows) { return row * row / float((rows - 1) * (rows - 1)); }

// The coordinate of the reference phase function of what has a peak, by the sine of half the scattering angle.
float peak_coordinate(float sine, int size) { return texture_coordinate(sqrt(sine), size); }

// Where layers lie along the way: from 0 at the start of a ray of some length to 1 at its end. They crowd where air is dense: towards
// a low eye, and towards the ground that a high eye sees.
float layer_place(float way, float length, bool grounded) {
    float scale = 0.02 * air_shell.y;
    float near = log(1.0 + way / scale) / log(1.0 + length / scale);
    float far = grounded ? 1.0 - log(1.0 + max(length - way, 0.0) / scale) / log(1.0 + length / scale) : way / length;
    return mix(near, far, ray_eye.y);
}

// The derivative of that place by the way.
float layer_slope(float way, float length, bool grounded) {
    float scale = 0.02 * air_shell.y, whole = log(1.0 + length / scale);
    float near = 1.0 / ((scale + way) * whole);
    float far = grounded ? 1.0 / ((scale + max(length - way, 0.0)) * whole) : 1.0 / length;
    return mix(near, far, ray_eye.y);
}
