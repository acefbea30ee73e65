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

// The distance from the eye beyond which everything is lit.
float shadows_end() { return shadow_count.x > 0 ? cascade_depth[shadow_count.x - 1].z : 0.0; }
