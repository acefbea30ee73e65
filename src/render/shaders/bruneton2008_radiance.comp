#version 450 core
// The light of one order around the points of one altitude: scattered in the air or by the ground. The delta S of the paper.
#include "bruneton2008_bake.glsl"
layout(std430, binding = 2) writeonly buffer Radiances { vec4 radiance[]; };  // [altitude][sun][angle][azimuth]

vec4 scattered_once(Way way, int direction, float mu_s, float nu) {
    OnceScattered once = gather_single(way, direction, mu_s, nu);
    float samples = float(textureSize(soft_phases, 0).x), u = (sqrt(acos(nu) / pi) * (samples - 1.0) + 0.5) / samples;
    vec4 sum = vec4(0.0);
    for (int i = 0; i < bake_scatterers; ++i) {
        vec4 phase = look_up(soft_phases, vec2(u, (float(i) + 0.5) / float(textureSize(soft_phases, 0).y)));
        sum += once.by[i] * air.scattering[bake_part_of[i / 4][i % 4]] * phase;
    }
    return sum;
}

vec4 from_ground(Way way, float mu_s, float nu) {
    float there = sun_along(way.h, mu_s, nu, way.end.x, 0.0);
    vec4 light = bake_order > 1 ? airlight_diffuse(diffuse, there) : max(there, 0.0) * airlight_sunlight(transmittance, 0.0, there);
    return light * air.ground_albedo / pi * way.transmittance;
}

void main() {
    int of_angle = bake_azimuths, of_sun = bake_angles * of_angle, i = int(gl_GlobalInvocationID.x);
    if (i >= bake_suns * of_sun) return;
    int sun = i / of_sun, direction = i % of_sun / of_angle, azimuth = i % of_angle;
    Way way = ways[bake_first * bake_angles + direction];
    float mu_s = sun_of_coordinate(float(sun) / float(bake_suns - 1));
    float cos_phi = cos(pi * (float(azimuth) + 0.5) / float(bake_azimuths));
    float nu = clamp(way.mu * mu_s + sqrt(max((1.0 - way.mu * way.mu) * (1.0 - mu_s * mu_s), 0.0)) * cos_phi, -1.0, 1.0);
    vec4 light = bake_order > 1 ? gather_multiple(way, direction, mu_s, nu) : scattered_once(way, direction, mu_s, nu);
    if (way.grounded > 0.5) light += from_ground(way, mu_s, nu);
    radiance[bake_first * bake_suns * of_sun + i] = light;
}
