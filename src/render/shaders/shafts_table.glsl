// Light scattered once between the eye and places along rays, without shadows, for light shafts: a texel for some directions of the
// picture, a layer for each place on the way. What lies between two places is the difference of two look-ups.
#include "shafts_way.glsl"

// Whether the way of directions that miss the ground and of those that meet it is divided alike. High up it would be too coarse.
bool one_way(AirRay start) { return start.empty == 0.0 && start.h < 5000.0; }

float whole_way(AirRay start) {
    float bottom = air_shell.x, top = air_shell.y;
    if (one_way(start)) return sqrt(start.h * (2.0 * bottom + start.h)) + sqrt(top * (2.0 * bottom + top));
    return way_in_air(start, 1e30);
}

// Places crowd towards the eye, but where the ground ends the way.
float power_of(AirRay start) { return one_way(start) ? 3.0 : (meets_ground(start.h, start.mu, air_shell.x) ? 1.0 : 2.0); }
