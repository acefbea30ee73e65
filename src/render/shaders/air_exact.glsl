// A method of air (docs/decisions/0010-air-methods.md): each ray is marched by the model `airlight`, four wavelengths at a time.
#include "air_view.glsl"
#define AIR_KNOWS_THE_MOON
// Of the ray that is marched: its direction, and its start, relative to the eye.
vec3 marched, marched_from;
Passing passing_at(float distance_m);
#define AIRLIGHT_PASSING passing_at
#include "air_spectral.glsl"

Passing passing_at(float distance_m) {
    return light_passing(marched_from + marched * distance_m, darkening_of_wavelength[0], darkening_of_wavelength[1]);
}

RadianceSpectrum scattered_once(AirlightLight light, float angle) {
    RadianceSpectrum sum = Spectrum(0.0);
    for (int p = 0; p < airlight_parts; ++p)
        if (p < air.parts) sum += light.single[p] * phase_of(p, angle);
    return sum;
}

AirSeen air_seen(vec3 direction, float distance_m) {
    AirRay ray;
    if (!enter_air(direction, ray)) return AirSeen(AirLight(0.0), AirLight(1.0), AirLight(0.0));
    AirlightRay way = AirlightRay(ray.h, ray.mu, ray.mu_s, ray.nu, distance_m - ray.empty);
    // Just short of the ground sphere, whose light is not the air's.
    if (meets_ground(ray.h, ray.mu, air.bottom)) way.limit = min(way.limit, 0.999999 * distance_to_ground(ray.h, ray.mu, air.bottom));
    if (way.limit <= 0.0) return AirSeen(AirLight(0.0), AirLight(1.0), AirLight(0.0));
    marched = direction, marched_from = direction * ray.empty;
    AirlightLight light = airlight_light(densities, transmittance, source, diffuse, way);
    RadianceSpectrum once = scattered_once(light, angle_between(direction, towards_sun.xyz));
    return AirSeen(once + light.multiple, light.transmittance, once);
}

AirLight air_sky(AirSeen seen, vec3 position, vec3 up, float h, vec3 direction) {
    marched = direction, marched_from = position;
    AirlightRay way = AirlightRay(min(h, air.top), dot(direction, up), dot(up, towards_sun.xyz), dot(direction, towards_sun.xyz), 1e30);
    AirlightLight light = airlight_light(densities, transmittance, source, diffuse, way);
    return scattered_once(light, angle_between(direction, towards_sun.xyz)) + light.multiple;
}

// The ground's, as much of it as the air above takes of the light that the whole air takes: so it is where light is scattered once.
AirLight air_skylight(float h, float mu_s) {
    vec4 taken = 1.0 - airlight_upward(transmittance, min(h, air.top), 1.0), whole = 1.0 - airlight_upward(transmittance, 0.0, 1.0);
    return air.solar_irradiance * airlight_diffuse(diffuse, mu_s) * taken / max(whole, 1e-9);
}
