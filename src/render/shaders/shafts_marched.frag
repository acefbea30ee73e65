#version 450 core
// Light shafts marched along each ray [Kaneda1991, who asked for the shadows of fog], at few places, which jitter from pixel to pixel
// by interleaved gradient noise [Jimenez2014]. Approximates: between two of the places either all is lit or nothing, so that edges
// are grains. Cost: 32 looks at the shadow maps and 33 at the table of light scattered once, each pixel.
#include "shafts_light.glsl"

const int steps = 32;

vec3 lit_share(vec2 place, vec3 direction, AirRay start, float way) {
    ShaftsView view = shafts_view(place, start);
    float jitter = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    vec3 lit = vec3(0.0), before = vec3(0.0);
    for (int i = 0; i < steps; ++i) {
        float t = (float(i) + jitter) / float(steps), to = float(i + 1) / float(steps);
        vec3 light = light_over(view, way * to * to);
        if (sun_sees(direction * (start.empty + way * t * t))) lit += light - before;
        before = light;
    }
    return share_of(lit, before);
}
#include "shafts.glsl"
