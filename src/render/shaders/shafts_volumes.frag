#version 450 core
// Light shafts by the length of the shadow along each ray and the difference of two look-ups in precomputed light [BrunetonNeyret2008,
// section 4]. Approximates: all of a ray's shadow lies at its far end, as it does behind one mountain; where it lies before the eye too
// much light stays. Lengths are found by 64 looks at the shadow maps: Bruneton draws shadow volumes of silhouettes instead, which ground
// of moving patches does not have. Cost: these, and two look-ups, each pixel.
#include "shafts_light.glsl"

const int steps = 64;

vec3 lit_share(vec2 place, vec3 direction, AirRay start, float way, vec2 part) {
    float dark = 0.0, from = part.x;
    for (int i = 0; i < steps; ++i) {
        float t = float(i + 1) / float(steps), to = part.x + (part.y - part.x) * t * t;
        if (!sun_sees(direction, start.empty + 0.5 * (from + to))) dark += to - from;
        from = to;
    }
    if (dark == 0.0) return vec3(1.0);
    ShaftsView view = shafts_view(place, direction, start);
    return share_of(light_over(view, max(way - dark, 0.0)), light_over(view, way));
}
#include "shafts.glsl"
