// Methods of air (docs/decisions/0010-air-methods.md) that look light up along the rays that were marched for this eye (air_march.glsl).
#include "air_rays.glsl"
layout(binding = 8) uniform sampler3D rays;
layout(binding = 9) uniform sampler2D peak;      // the reference phase function, by peak_coordinate
layout(binding = 10) uniform sampler2D sunlight;  // logarithm of the irradiance of the whole sun's disk, [altitude][cosine]
layout(binding = 11) uniform sampler2D skylight;  // logarithm of that of a level surface by the sky, [altitude][sun_coordinate]
layout(binding = 12) uniform sampler2D sky;       // radiance at the ends of ways into the sky of an eye in the air, by column and sky_row, of what
                                                  // has no peak; beside it, of what has one over `peak`
#define AirLight vec3

// Light of the air between the eye and a place.
struct RayLight {
    vec3 even;    // what has no peak, however often it was scattered
    vec3 once;    // of it, what was scattered once
    vec3 peaked;  // what has one, over `peak`
    vec3 depth, transmittance;
};

struct AirSeen {
    AirLight inscattered;
    AirLight transmittance;
    AirLight once;
    RayLight light;
};

vec3 colour_of(AirLight light) { return light; }

vec3 colour_through(vec3 colour, AirLight seen) { return colour * seen; }

float peak_at(vec3 direction) {
    float x = peak_coordinate(min(0.5 * length(direction - towards_sun.xyz), 1.0), textureSize(peak, 0).x);
    return look_up(peak, vec2(x, 0.5)).r;
}

// At a column and row of the grid, after some way of a whole length.
RayLight light_at(float column, float row, float way, float length, bool grounded) {
    float layer = layer_place(way, length, grounded) * float(ray_counts.w);
    vec3 place = (vec3(column, row, layer) + 0.5) / vec3(textureSize(rays, 0)), next = vec3(1.0 / float(ray_parts), 0.0, 0.0);
    vec4 even = look_up(rays, place + float(ray_smooth) * next);
    RayLight light;
    light.depth = look_up(rays, place + float(ray_extinction) * next).rgb * way;
    light.transmittance = exp(-light.depth);
    vec3 scale = exp(even.a) * (1.0 - light.transmittance);
    light.even = scale * even.rgb;
    light.once = light.even * look_up(rays, place + float(ray_once) * next).rgb;
    light.peaked = scale * look_up(rays, place + float(ray_peaked) * next).rgb;
    return light;
}

RayLight ray_light(vec3 direction, float distance_m) {
    AirRay ray;
    if (!enter_air(direction, ray)) return RayLight(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(1.0));
    bool grounded = meets_ground(ray.h, ray.mu, air_shell.x);
    float mu = dot(direction, eye_up.xyz);
    float length = grounded ? distance_to_ground(ray.h, ray.mu, air_shell.x) : distance_to_top(ray.h, ray.mu, air_shell.x, air_shell.y);
    length = max(length, 1e-3);
    float way = clamp(distance_m - ray.empty, 0.0, length);
    return light_at(column_of(mu, dot(eye_up.xyz, towards_sun.xyz), ray.nu), row_of(mu, grounded), way, length, grounded);
}

AirSeen air_seen(vec3 direction, float distance_m) {
    RayLight light = ray_light(direction, distance_m);
    vec3 peaked = light.peaked * peak_at(direction);
    return AirSeen(light.even + peaked, light.transmittance, light.once + peaked, light);
}

// Rays are known from the eye alone. But the air between the eye and the place is that through which light of the sky comes down to it,
// on a way that is as long if it is the mirror's: its light is turned into the other direction, as air and haze scatter it; and above it the sky
// is the eye's, at the same angle from the zenith.
AirLight air_sky(AirSeen seen, vec3 position, vec3 up, float h, vec3 direction) {
    vec3 view = normalize(position), to_sun = towards_sun.xyz;
    float mu = dot(direction, up), mu_s = dot(eye_up.xyz, to_sun), nu = dot(direction, to_sun), nu_view = dot(view, to_sun);
    RayLight layer = seen.light;
    float turn = (mu + dot(direction, eye_up.xyz)) / (1.0 + dot(up, eye_up.xyz));  // brings the place's zenith to the eye's
    float nu_eye = nu - turn * (dot(up, to_sun) + mu_s) + 2.0 * mu * mu_s;
    vec2 place = (vec2(column_of(mu, mu_s, nu_eye), sky_row(mu, textureSize(sky, 0).y)) + 0.5) / vec2(textureSize(sky, 0));
    float ways = clamp(-dot(view, up) / mu, 0.0, 10.0);
    vec3 taken = 1.0 - layer.transmittance, left = exp(-ways * layer.depth);
    vec3 share = mix((1.0 - left) / max(taken, 1e-4), vec3(ways), lessThan(taken, vec3(1e-4)));
    vec3 once = layer.once * (1.0 + nu * nu) / (1.0 + nu_view * nu_view);
    vec3 even = (layer.even - layer.once + once) * share + left * look_up(sky, place).rgb;
    return even + peak_at(direction) * (layer.peaked * share + left * look_up(sky, place + vec2(0.5, 0.0)).rgb);
}

AirLight air_sunlight(float h, float mu_s) {
    vec2 size = vec2(textureSize(sunlight, 0));
    float low = min(h, air_shell.y), mu = max(mu_s, horizon_cosine(low, air_shell.x));
    vec2 place = vec2(transmittance_cosine_coordinate(low, mu, air_shell.x, air_shell.y), altitude_coordinate(low, air_shell.y));
    return sun_above_horizon(low, mu_s, air_shell.x, towards_sun.w) * 
           exp(textureLod(sunlight, (place * (size - 1.0) + 0.5) / size, 0.0).rgb);
}

AirLight air_skylight(float h, float mu_s) {
    vec2 size = vec2(textureSize(skylight, 0)), place = vec2(sun_coordinate(mu_s), altitude_coordinate(h, air_shell.y));
    return exp(look_up(skylight, (place * (size - 1.0) + 0.5) / size).rgb);
}
