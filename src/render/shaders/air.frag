#version 450 core
// The air before what the geometry buffer holds, the light that comes through it to surfaces and from them to the eye, the sky and the
// sun's disk: four wavelengths of the model `airlight`, turned into colour by their weights (src/render/air_pass.h).
#include "camera.glsl"
#include "octahedral.glsl"
#include "physics/readings/glsl.glsl"
#include "physics/shell.glsl"
#include "physics/maps.glsl"
#include "physics/models/airlight_air.glsl"
#include "physics/models/airlight.glsl"
#include "surface_light.glsl"
layout(binding = 0) uniform sampler2D depth_buffer;
layout(binding = 1) uniform sampler2D colour_buffer;
layout(binding = 2) uniform sampler2D normal_buffer;
layout(binding = 3) uniform sampler2D material_buffer;
layout(binding = 4) uniform sampler2D densities;
layout(binding = 5) uniform sampler2D transmittance;
layout(binding = 6) uniform sampler3D source;
layout(binding = 7) uniform sampler2D diffuse;
layout(binding = 8) uniform sampler2D phases;  // [constituent][sample], even in the root of the scattering angle
layout(std140, binding = 2) uniform AirView {
    vec4 eye_up;       // away from the planet's centre, of length one; the eye's altitude
    vec4 towards_sun;  // of length one
};
layout(std140, binding = 3) uniform AirColours {
    vec4 colour_of_wavelength[4];
    vec4 limb_darkening[2];
};
layout(location = 0) in vec2 place;
layout(location = 0) out vec4 radiance;

vec3 colour_of(Spectrum light) {
    vec3 sum = vec3(0.0);
    for (int w = 0; w < N; ++w) sum += light[w] * colour_of_wavelength[w].rgb;
    return sum;
}

// The angle between two directions of length one. Not by acos, which near 0 is off by the root of its argument's rounding.
float angle_between(vec3 a, vec3 b) { return atan(length(cross(a, b)), dot(a, b)); }

// The part within the air of a ray from the eye over a distance; false if nothing of it is.
bool enter_air(vec3 direction, float distance_m, out AirlightRay ray) {
    vec3 up = eye_up.xyz;
    ray = AirlightRay(max(eye_up.w, 0.0), dot(direction, up), dot(up, towards_sun.xyz), dot(direction, towards_sun.xyz), distance_m);
    if (ray.h <= air.top) return true;
    float r = air.bottom + ray.h, top = air.bottom + air.top;
    float beside = r * length(cross(direction, up));  // how far from the centre it passes
    float inside = (top - beside) * (top + beside);
    if (ray.mu >= 0.0 || inside <= 0.0) return false;
    float way = (ray.h - air.top) * (r + top) / (sqrt(inside) - r * ray.mu);
    ray = AirlightRay(air.top, -sqrt(inside) / top, clamp((r * ray.mu_s + ray.nu * way) / top, -1.0, 1.0), ray.nu, distance_m - way);
    return ray.limit > 0.0;
}

RadianceSpectrum scattered(AirlightLight light, float angle) {
    float samples = float(textureSize(phases, 0).x);
    float u = (sqrt(angle / pi) * (samples - 1.0) + 0.5) / samples;
    RadianceSpectrum sum = light.multiple;
    for (int p = 0; p < airlight_parts; ++p)
        if (p < air.parts) sum += light.single[p] * look_up(phases, vec2(u, (float(p) + 0.5) / float(airlight_parts)));
    return sum;
}

// The sun's disk above the air, averaged over a pixel of `width` radians.
RadianceSpectrum sun_disk(float angle, float width) {
    float radius = air.sun_radius;
    float covered = radius > 0.0 ? clamp((radius - angle) / width + 0.5, 0.0, 1.0) * min(1.0, pi * radius * radius / (width * width)) : 0.0;
    if (covered <= 0.0) return Spectrum(0.0);
    float s = min(angle / radius, 1.0), dark = 1.0 - sqrt(1.0 - s * s);
    Spectrum shape = 1.0 - limb_darkening[0] * dark - limb_darkening[1] * (dark * dark);
    Spectrum mean = 1.0 - limb_darkening[0] / 3.0 - limb_darkening[1] / 6.0;
    return air.solar_irradiance * shape / mean * (covered / (pi * radius * radius));
}

// What a surface sends to the eye, of which the part `seen` comes through.
vec3 surface_seen(ivec2 pixel, vec3 position, vec3 reflectance, Spectrum seen) {
    dvec3 from_centre = camera_eye_m.xyz + dvec3(position);
    float h = max(float(length(from_centre) - double(air.bottom)), 0.0);
    vec3 up = normalize(vec3(from_centre));
    vec3 n = from_octahedral(texelFetch(normal_buffer, pixel, 0).rg);
    SurfaceLight light =
        surface_light(reflectance, texelFetch(material_buffer, pixel, 0).rg, n, up, -normalize(position), towards_sun.xyz);
    float mu_s = clamp(dot(up, towards_sun.xyz), -1.0, 1.0);
    Spectrum arrives = seen * air.solar_irradiance;
    return light.of_sun * colour_of(arrives * airlight_sunlight(transmittance, min(h, air.top), mu_s)) +
           light.of_sky * colour_of(arrives * airlight_diffuse(diffuse, mu_s));
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 direction = normalize(view_ray(place));
    float width = length(dFdx(direction)), sun_angle = angle_between(direction, towards_sun.xyz);
    vec4 colour = texelFetch(colour_buffer, pixel, 0);
    bool surface = colour.a > 0.0;
    vec3 position = surface ? position_at(place, texelFetch(depth_buffer, pixel, 0).r) : vec3(0.0);

    AirlightRay ray;
    Spectrum seen = Spectrum(1.0);
    vec3 sum = vec3(0.0);
    bool grounded = false;
    if (enter_air(direction, surface ? length(position) : 1e30, ray)) {
        grounded = meets_ground(ray.h, ray.mu, air.bottom);
        // Just short of the ground sphere, whose light is not the surface's.
        if (surface && grounded) ray.limit = min(ray.limit, 0.999999 * distance_to_ground(ray.h, ray.mu, air.bottom));
        AirlightLight light = airlight_light(densities, transmittance, source, diffuse, ray);
        seen = light.transmittance;
        sum = colour_of(scattered(light, sun_angle));
    }
    if (surface) sum += surface_seen(pixel, position, colour.rgb, seen);
    else if (!grounded) sum += colour_of(seen * sun_disk(sun_angle, width));
    radiance = vec4(sum, 1.0);
}
