// The picture that any method of air makes: what stands above the air and what the geometry buffer holds, seen through it.
// The text of a method stands before this one and answers (docs/decisions/0010-air-methods.md):
//
//   AirLight                                            light of some wavelengths, or red, green and blue
//   struct AirSeen { AirLight inscattered, transmittance, once; }
//                                                       `once`: of inscattered, the light that was scattered once
//   AirSeen air_seen(vec3 direction, float distance_m)   the air between the eye and a place; it ends at the ground sphere
//   AirLight air_sunlight(float h, float mu_s)           irradiance of a surface at an altitude that faces the sun
//   AirLight air_skylight(float h, float mu_s)           irradiance of a level surface by the whole sky above it but the sun
//   AirLight air_sky(AirSeen seen, vec3 position, vec3 up, float h, vec3 direction)
//                                                       radiance of the sky above a place, which is seen so, relative to the eye
//   vec3 colour_of(AirLight light)                       red, green and blue
//   vec3 colour_through(vec3 colour, AirLight seen)      what is left of light of a colour and the sun's spectrum
//
// What the geometry buffer holds and the rest, which is the sky and the ground sphere, are drawn by programs of their own; that of the rest
// defines AIR_WITHOUT_SURFACES. Pictures without an eclipse define AIR_WITHOUT_MOON, those without water AIR_WITHOUT_WATER.
//
// Where a method draws several times, each with a share of the wavelengths, its pictures add up.
#include "camera.glsl"
#include "octahedral.glsl"
#include "surface_light.glsl"
layout(binding = 0) uniform sampler2D depth_buffer;
layout(binding = 1) uniform sampler2D colour_buffer;
layout(binding = 2) uniform sampler2D normal_buffer;
layout(binding = 3) uniform sampler2D material_buffer;
layout(binding = 4) uniform sampler2D background_buffer;
layout(binding = 7) uniform sampler2D shade_buffer;  // src/render/shafts_pass.h
layout(location = 0) in vec2 place;
layout(location = 0) out vec4 radiance;

// What is seen at a pixel, if it is not the sky.
struct Surface {
    bool there;
    vec3 position;  // from the eye
    vec3 up;        // away from the planet's centre, there
    float h;        // altitude
    vec3 reflectance, normal;
    vec2 material;
};

Surface surface_at(ivec2 pixel, vec3 direction) {
    float h = max(eye_up.w, 0.0), mu = dot(direction, eye_up.xyz);
    Surface surface;
#ifdef AIR_WITHOUT_SURFACES
    surface.there = meets_ground(h, mu, air_shell.x);
    surface.position = surface.there ? direction * distance_to_ground(h, mu, air_shell.x) : vec3(0.0);
#else
    surface.there = true;
    surface.position = position_at(place, texelFetch(depth_buffer, pixel, 0).r);
#endif
    surface.up = normalize(eye_up.xyz * (air_shell.x + h) + surface.position);
#ifdef AIR_WITHOUT_SURFACES
    surface.h = 0.0;
    surface.reflectance = ground_albedo.rgb;
    surface.normal = surface.up;
    surface.material = vec2(1.0, 0.0);
#else
    surface.h = max(altitude_at(h, mu, length(surface.position), air_shell.x), 0.0);
    surface.reflectance = texelFetch(colour_buffer, pixel, 0).rgb;
    surface.normal = from_octahedral(texelFetch(normal_buffer, pixel, 0).rg);
    surface.material = texelFetch(material_buffer, pixel, 0).rg;
#endif
    return surface;
}

// Altitude and zenith cosine of the sun at which sunlight on its way to a place is asked for: there, or where the way leaves the air for
// good, if that is below the place.
vec2 sunlit_from(float h, float mu_s) {
    float top = air_shell.y, r_top = air_shell.x + top, beside = (air_shell.x + h) * sqrt(max(1.0 - mu_s * mu_s, 0.0));
    if (h <= top || mu_s >= 0.0) return vec2(h, mu_s);
    float inside = (r_top - beside) * (r_top + beside);
    return vec2(top, inside > 0.0 ? -sqrt(inside) / r_top : 1.0);
}

// The sky in water. Of a method that does not know the moon a share is `lit`. The light between the stars is that of all directions in the
// mean, twice what air scatters of it.
vec3 mirrored_sky(Surface surface, vec3 direction, vec3 lit, AirSeen seen) {
    Mirror mirror = mirror_of(surface.normal, surface.up, -direction, surface.material.r);
    AirLight sky = air_sky(seen, surface.position, surface.up, surface.h, mirror.direction);
#ifdef AIR_KNOWS_THE_MOON
    lit = vec3(1.0);
#endif
    vec3 night = colour_through(2.0 * night_scattered.rgb, seen.transmittance);
    return surface.material.g * mirror.share * (lit * colour_of(seen.transmittance * sky) + night);
}

void main() {
    vec3 direction = normalize(view_ray(place));
    Surface surface = surface_at(ivec2(gl_FragCoord.xy), direction);
    float distance_m = surface.there ? length(surface.position) : 1e30;
    AirSeen seen = air_seen(direction, distance_m);
#if defined(AIR_KNOWS_THE_MOON) || defined(AIR_WITHOUT_MOON)
    Passing air_lit = Passing(vec4(1.0), vec4(1.0));
#else
    Passing air_lit = air_passing(direction, distance_m);
#endif
    // Of light scattered once, and of the sun's on surfaces, shadows leave a share.
    vec4 shade = textureLod(shade_buffer, 0.5 * place + 0.5, 0.0);
    vec3 sum = air_lit.sky.rgb * colour_of(seen.inscattered) + (air_lit.sun.rgb * shade.rgb - air_lit.sky.rgb) * colour_of(seen.once) +
               colour_through(night_scattered.rgb, AirLight(1.0) - seen.transmittance);
    if (surface.there) {
        SurfaceLight light =
            surface_light(surface.reflectance, surface.material, surface.normal, surface.up, -direction, towards_sun.xyz);
        float mu_s = clamp(dot(surface.up, towards_sun.xyz), -1.0, 1.0);
        vec2 from = sunlit_from(surface.h, mu_s);
#ifdef AIR_WITHOUT_MOON
        Passing lit = Passing(vec4(1.0), vec4(1.0));
#else
        Passing lit = light_passing(surface.position, limb_darkening[0], limb_darkening[1]);
#endif
        sum += shade.a * light.of_sun * lit.sun.rgb * colour_of(seen.transmittance * air_sunlight(from.x, from.y)) +
               light.of_sky * lit.sky.rgb * colour_of(seen.transmittance * air_skylight(surface.h, mu_s)) +
               light.of_sky * colour_through(night_illuminance.rgb, seen.transmittance);
#ifndef AIR_WITHOUT_WATER
        if (surface.material.g > 0.0) sum += mirrored_sky(surface, direction, lit.sky.rgb, seen);
#endif
    } else {
        vec3 background = air_shell.z > 0.0 ? texelFetch(background_buffer, ivec2(gl_FragCoord.xy), 0).rgb : vec3(0.0);
        sum += colour_through(background, seen.transmittance);
    }
    radiance = vec4(sum, 1.0);
}
