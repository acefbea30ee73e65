// Methods of air (docs/decisions/0010-air-methods.md) that look light up along the rays that were marched for this eye (air_march.glsl).
#include "air_rays.glsl"
layout(binding = 8) uniform sampler3D smooth_light;   // radiance, over the share of light that the way takes, of what has no peak, over
                                                      // a scale; the logarithm of that scale
layout(binding = 9) uniform sampler3D peaked_light;   // the same of what has one, over the same and over `peak`
layout(binding = 10) uniform sampler3D extinction;    // its mean along the way
layout(binding = 11) uniform sampler2D peak;          // a phase function, even in the root of the scattering angle
layout(binding = 12) uniform sampler2D sunlight;      // logarithm of the irradiance of the whole sun's disk, [altitude][cosine]
layout(binding = 13) uniform sampler2D skylight;      // logarithm of that on level ground, [sun_coordinate]
layout(binding = 14) uniform sampler3D once_share;    // of smooth_light, what was scattered once
#define AirLight vec3

// Light of the air between the eye and a place.
struct RayLight {
    vec3 even;    // what has no peak, however often it was scattered
    vec3 once;    // of it, what was scattered once
    vec3 peaked;  // what has one, over `peak`
    vec3 transmittance;
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
    float x = texture_coordinate(sqrt(angle_between(direction, towards_sun.xyz) / pi), textureSize(peak, 0).x);
    return look_up(peak, vec2(x, 0.5)).r;
}

RayLight ray_light(vec3 direction, float distance_m) {
    AirRay ray;
    if (!enter_air(direction, ray)) return RayLight(vec3(0.0), vec3(0.0), vec3(0.0), vec3(1.0));
    bool grounded = meets_ground(ray.h, ray.mu, air_shell.x);
    float mu = dot(direction, eye_up.xyz), zenith = angle_between(direction, eye_up.xyz);
    float length = grounded ? distance_to_ground(ray.h, ray.mu, air_shell.x) : distance_to_top(ray.h, ray.mu, air_shell.x, air_shell.y);
    length = max(length, 1e-3);
    float way = clamp(distance_m - ray.empty, 0.0, length);
    float azimuth = azimuth_coordinate(relative_azimuth_cosine(mu, dot(eye_up.xyz, towards_sun.xyz), ray.nu)) * float(ray_counts.y - 1);
    float layer = layer_place(way, length, grounded) * float(ray_counts.w);
    vec3 place = (vec3(azimuth, row_of(zenith, mu, grounded), layer) + 0.5) / vec3(textureSize(smooth_light, 0));
    vec4 even = textureLod(smooth_light, place, 0.0);
    RayLight light;
    light.transmittance = exp(-textureLod(extinction, place, 0.0).rgb * way);
    vec3 scale = exp(even.a) * (1.0 - light.transmittance);
    light.even = scale * even.rgb;
    light.once = light.even * textureLod(once_share, place, 0.0).rgb;
    light.peaked = scale * textureLod(peaked_light, place, 0.0).rgb;
    return light;
}

AirSeen air_seen(vec3 direction, float distance_m) {
    RayLight light = ray_light(direction, distance_m);
    vec3 peaked = light.peaked * peak_at(direction);
    return AirSeen(light.even + peaked, light.transmittance, light.once + peaked, light);
}

// Rays are known from the eye alone. But the air between the eye and the place is that through which light of the sky comes down to it,
// on a way that is as long if it is the mirror's: its light is turned into the other direction, as air and haze scatter it; and above it the sky
// is the eye's.
AirLight air_sky(AirSeen seen, vec3 position, vec3 up, float h, vec3 direction) {
    vec3 view = normalize(position), to_sun = towards_sun.xyz, both = up + eye_up.xyz;
    RayLight layer = seen.light;
    vec3 from_eye = direction - dot(both, direction) / (1.0 + dot(up, eye_up.xyz)) * both + 2.0 * dot(up, direction) * eye_up.xyz;
    RayLight above = ray_light(from_eye, 1e30);
    float ways = clamp(-dot(view, up) / dot(direction, up), 0.0, 10.0);
    float nu = dot(direction, to_sun), nu_view = dot(view, to_sun);
    vec3 taken = 1.0 - layer.transmittance, left = pow(layer.transmittance, vec3(ways));
    vec3 share = mix((1.0 - left) / max(taken, 1e-4), vec3(ways), lessThan(taken, vec3(1e-4)));
    vec3 once = layer.once * (1.0 + nu * nu) / (1.0 + nu_view * nu_view), peaked = peak_at(direction) * (layer.peaked * share + left * above.peaked);
    return (layer.even - layer.once + once) * share + left * above.even + peaked;
}

AirLight air_sunlight(float h, float mu_s) {
    vec2 size = vec2(textureSize(sunlight, 0));
    float low = min(h, air_shell.y), mu = max(mu_s, horizon_cosine(low, air_shell.x));
    vec2 place = vec2(transmittance_cosine_coordinate(low, mu, air_shell.x, air_shell.y), altitude_coordinate(low, air_shell.y));
    return sun_above_horizon(low, mu_s, air_shell.x, towards_sun.w) * 
           exp(textureLod(sunlight, (place * (size - 1.0) + 0.5) / size, 0.0).rgb);
}

AirLight air_skylight(float mu_s) {
    return exp(look_up(skylight, vec2(texture_coordinate(sun_coordinate(mu_s), textureSize(skylight, 0).x), 0.5)).rgb);
}
