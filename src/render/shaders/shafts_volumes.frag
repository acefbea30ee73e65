#version 450 core
// Light shafts by the length of the shadow along each ray and the difference of two look-ups in precomputed light [BrunetonNeyret2008,
// section 4]. Approximates: all of a ray's shadow lies at its far end, as it does behind one mountain; where it lies before the eye too
// much light stays. Lengths are found by 64 looks at the shadow maps: Bruneton draws shadow volumes of silhouettes instead, which ground
// of moving patches does not have. Cost: these, and two look-ups, each pixel.
#include "shafts_light.glsl"

const int steps = 64;

vec3 lit_share(vec2 place, vec3 direction, AirRay start, float way) {
    ShaftsView view = shafts_view(place, start);
    float lit = 0.0, from = 0.0;
    for (int i = 0; i < steps; ++i) {
        float t = float(i + 1) / float(steps), to = way * t * t;
        if (sun_sees(direction * (start.empty + 0.5 * (from + to)))) lit += to - from;
        from = to;
    }
    if (lit >= 0.9999 * way) return vec3(1.0);
    return share_of(light_over(view, lit), light_over(view, way));
}
#include "shafts.glsl"
