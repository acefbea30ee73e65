// A method of air (docs/decisions/0010-air-methods.md): the tables of bruneton2008, four wavelengths at a time.
#include "air_view.glsl"
#include "air_spectral.glsl"
#include "physics/models/bruneton2008.glsl"
layout(binding = 13) uniform sampler3D scattering;  // [table and altitude][view][nu and sun]
layout(std140, binding = 4) uniform Bruneton2008Block {
    AirlightAxis altitudes;
    int view_texels, sun_texels, nu_texels;
    int scatterers;  // constituents that scatter
    int twilight;
    ivec4 part_of[2];
};

// Transmittance of the first part of a ray, which is within the air. By the columns of air on it: the quotient of two look-ups loses what is before
// near surfaces beside the horizon.
vec4 transmittance_over(AirRay ray, float distance_m) {
    float start = (air.bottom + ray.h) * ray.mu, end = start + distance_m, reach = 0.0;
    AirlightColumns columns;
    for (int p = 0; p < airlight_parts; ++p) columns.of[p] = 0.0;
    for (float x = start; x < end;) {
        float to = airlight_next_cut(densities, ray.h, start, x, end, reach);
        AirlightPiece piece = airlight_piece(ray.h, start, x, to);
        airlight_add_columns(densities, piece, 0.0, 0.5, columns);
        airlight_add_columns(densities, piece, 0.5, 1.0, columns);
        x = to;
    }
    return airlight_transmittance(columns);
}

// The place at a distance along a ray.
AirRay moved(AirRay ray, float distance_m) {
    AirRay to = ray;
    to.h = clamp(altitude_at(ray.h, ray.mu, distance_m, air.bottom), 0.0, air.top);
    to.mu = cosine_at(ray.h, ray.mu, distance_m, to.h, air.bottom);
    to.mu_s = sun_cosine_at(ray.h, ray.mu_s, ray.nu, distance_m, to.h, air.bottom);
    return to;
}

// All the light of the air from a place on a ray on, and of it what was scattered once.
struct TableLight {
    vec4 all;
    vec4 once;
};

TableLight light_from(AirRay ray, bool grounded, float angle) {
    Bruneton2008 shape = bruneton2008(air.bottom, air.top, altitudes.texels, view_texels, sun_texels, nu_texels);
    shape.twilight = twilight != 0;
    Bruneton2008Place place = bruneton2008_place(shape, ray.h, ray.mu, ray.mu_s, ray.nu, grounded);
    float tables = float(1 + scatterers), altitude = (airlight_texel(altitudes, ray.h, air.top) + 0.5) / float(altitudes.texels);
    place.altitude = altitude / tables;
    vec4 root = bruneton2008_multiple(scattering, place);
    TableLight light = TableLight(root * root, vec4(0.0));
    for (int i = 0; i < scatterers; ++i) {
        place.altitude = (altitude + float(1 + i)) / tables;
        root = bruneton2008_single(scattering, place);
        light.once += root * root * phase_of(part_of[i / 4][i % 4], angle);
    }
    light.all += light.once;
    float gain = grounded ? bruneton2008_gain(distance_to_ground(ray.h, ray.mu, air.bottom)) : 1.0;
    return TableLight(light.all * gain, light.once * gain);
}

AirSeen air_seen(vec3 direction, float distance_m) {
    AirRay ray;
    if (!enter_air(direction, ray) || distance_m <= ray.empty) return AirSeen(AirLight(0.0), AirLight(1.0), AirLight(0.0));
    bool grounded = meets_ground(ray.h, ray.mu, air.bottom);
    float limit = distance_m - ray.empty, whole = airlight_length(ray.h, ray.mu, grounded), angle = angle_between(direction, towards_sun.xyz);
    TableLight light = light_from(ray, grounded, angle);
    if (limit >= whole)
        return AirSeen(light.all, grounded ? transmittance_over(ray, whole) : airlight_upward(transmittance, ray.h, ray.mu), light.once);
    vec4 seen = transmittance_over(ray, limit);
    TableLight beyond = light_from(moved(ray, limit), grounded, angle);
    vec4 all = max(light.all - seen * beyond.all, vec4(0.0));
    return AirSeen(all, seen, clamp(light.once - seen * beyond.once, vec4(0.0), all));
}

AirLight air_sky(AirSeen seen, vec3 position, vec3 up, float h, vec3 direction) {
    vec3 to_sun = towards_sun.xyz;
    AirRay ray = AirRay(min(h, air.top), dot(direction, up), dot(up, to_sun), dot(direction, to_sun), 0.0);
    return light_from(ray, false, angle_between(direction, to_sun)).all;
}

// `diffuse` has a row for each altitude.
AirLight air_skylight(float h, float mu_s) {
    float row = airlight_texel(air.source_axis, min(h, air.top), air.top);
    vec2 at = vec2(texture_coordinate(sun_coordinate(mu_s), air.sun_texels), (row + 0.5) / float(air.source_axis.texels));
    return air.solar_irradiance * exp(look_up(diffuse, at) * air.log_range + air.log_low);
}
