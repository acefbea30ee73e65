#version 450 core
// Light shafts by brute force: a thousand places of each ray are asked whether the sun sees them. The truth for the other methods; it
// approximates nothing but the steps' length. Cost: 1024 times the air's six tables and the shadow maps, each pixel.
#include "shafts_way.glsl"

const int steps = 1024;

vec3 lit_share(vec2 place, vec3 direction, AirRay start, float way, vec2 part) {
    ShaftsRay ray = shafts_ray(start, direction);
    vec3 depth = vec3(0.0), lit = vec3(0.0), all = vec3(1e-30);
    float from = 0.0;
    for (int i = 0; i < steps; ++i) {
        float t = float(i + 1) / float(steps), to = way * t * t, middle = 0.5 * (from + to);
        Scattered there = scattered_at(ray, middle);
        vec3 light = (there.even + there.peaked) * exp(-depth - 0.5 * (to - from) * there.extinction) * (to - from);
        depth += (to - from) * there.extinction;
        all += light;
        if (sun_sees(direction, start.empty + middle)) lit += light;
        from = to;
    }
    return lit / all;
}
#include "shafts.glsl"
