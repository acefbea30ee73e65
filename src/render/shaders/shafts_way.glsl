// How far a ray of light shafts runs: through the air, at most to where shadows end.
#include "shafts_air.glsl"
#include "shadow.glsl"

// From the start of its air to the surface, the ground sphere or the top of the air.
float way_in_air(AirRay start, float distance_m) {
    float bottom = air_shell.x, way = distance_m - start.empty;
    if (distance_m > 1e29)
        way = meets_ground(start.h, start.mu, bottom) ? distance_to_ground(start.h, start.mu, bottom)
                                                       : distance_to_top(start.h, start.mu, bottom, air_shell.y);
    return way;
}

// The part of a way where ground may be higher: from x to y, none if y <= x. Beyond the last shadow map all is lit.
vec2 shaded_part(AirRay start, float way) {
    if (shadow_count.x == 0) return vec2(0.0);
    float bottom = air_shell.x, highest = min(light_towards_sun.w, air_shell.y), reach = cascade_depth[shadow_count.x - 1].z - start.empty;
    vec2 part = vec2(0.0, min(way, reach));
    bool grounded = meets_ground(start.h, start.mu, bottom);
    if (start.h > highest) {
        float r = bottom + start.h, r_highest = bottom + highest, beside = r * sqrt(max(1.0 - start.mu * start.mu, 0.0));
        float inside = (r_highest - beside) * (r_highest + beside);
        if (start.mu >= 0.0 || inside <= 0.0) return vec2(0.0);
        part.x = (start.h - highest) * (r + r_highest) / (sqrt(inside) - r * start.mu);
        if (!grounded) part.y = min(part.y, part.x + 2.0 * sqrt(inside));
    } else if (!grounded) {
        part.y = min(part.y, distance_to_top(start.h, start.mu, bottom, highest));
    }
    return part;
}
