// A method of air (docs/decisions/0010-air-methods.md): each ray is marched by the model `airlight`, four wavelengths at a time.
#include "air_view.glsl"
#include "physics/maps.glsl"
#include "physics/models/airlight_air.glsl"
#include "physics/models/airlight.glsl"
layout(binding = 8) uniform sampler2D densities;
layout(binding = 9) uniform sampler2D transmittance;
layout(binding = 10) uniform sampler3D source;
layout(binding = 11) uniform sampler2D diffuse;
layout(binding = 12) uniform sampler2D phases;  // [constituent][sample], even in the root of the scattering angle
layout(std140, binding = 3) uniform AirColours { vec4 colour_of_wavelength[4]; };
#define AirLight vec4

struct AirSeen {
    AirLight inscattered;
    AirLight transmittance;
};

vec3 colour_of(AirLight light) {
    vec3 sum = vec3(0.0);
    for (int w = 0; w < N; ++w) sum += light[w] * colour_of_wavelength[w].rgb;
    return sum;
}

vec3 colour_through(vec3 colour, AirLight seen) { return colour * colour_of(air.solar_irradiance * seen) / colour_of_sun.rgb; }

RadianceSpectrum scattered(AirlightLight light, float angle) {
    float samples = float(textureSize(phases, 0).x);
    float u = (sqrt(angle / pi) * (samples - 1.0) + 0.5) / samples;
    RadianceSpectrum sum = light.multiple;
    for (int p = 0; p < airlight_parts; ++p)
        if (p < air.parts) sum += light.single[p] * look_up(phases, vec2(u, (float(p) + 0.5) / float(airlight_parts)));
    return sum;
}

AirSeen air_along(vec3 direction, AirRay ray, float limit) {
    AirlightRay way = AirlightRay(ray.h, ray.mu, ray.mu_s, ray.nu, limit);
    AirlightLight light = airlight_light(densities, transmittance, source, diffuse, way);
    return AirSeen(scattered(light, angle_between(direction, towards_sun.xyz)), light.transmittance);
}

AirSeen air_before(vec3 direction, float distance_m) {
    AirRay ray;
    if (!enter_air(direction, ray) || distance_m <= ray.empty) return AirSeen(AirLight(0.0), AirLight(1.0));
    float limit = distance_m - ray.empty;
    // Just short of the ground sphere, whose light is not the surface's.
    if (meets_ground(ray.h, ray.mu, air.bottom)) limit = min(limit, 0.999999 * distance_to_ground(ray.h, ray.mu, air.bottom));
    return air_along(direction, ray, limit);
}

AirSeen air_beyond(vec3 direction) {
    AirRay ray;
    if (!enter_air(direction, ray)) return AirSeen(AirLight(0.0), AirLight(1.0));
    AirSeen seen = air_along(direction, ray, 1e30);
    if (meets_ground(ray.h, ray.mu, air.bottom)) seen.transmittance = AirLight(0.0);
    return seen;
}

AirLight air_sunlight(float h, float mu_s) { return air.solar_irradiance * airlight_sunlight(transmittance, min(h, air.top), mu_s); }

AirLight air_skylight(float mu_s) { return air.solar_irradiance * airlight_diffuse(diffuse, mu_s); }
