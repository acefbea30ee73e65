#version 450 core
// Light shafts marched along each ray [Kaneda1991, who asked for the shadows of fog], at few places, which jitter from pixel to pixel
// by interleaved gradient noise [Jimenez2014]. Approximates: between two of the places either all is lit or nothing, so that edges
// are grains. Cost: 32 looks at the shadow maps, and one at the table of light scattered once for each edge, each pixel.
#include "shafts_light.glsl"

const int steps = 32;

vec3 lit_share(vec2 place, vec3 direction, AirRay start, float way, vec2 part) {
    ShaftsView view = shafts_view(place, direction, start);
    LitSum sum = lit_from_the_eye();
    float jitter = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    for (int i = 0; i < steps; ++i) {
        vec2 t = (float(i) + vec2(0.0, jitter)) / float(steps), at = part.x + (part.y - part.x) * t * t;
        go_on(sum, view, at.x, sun_sees(direction, start.empty + at.y) ? 1.0 : 0.0);
    }
    go_on(sum, view, part.y, 1.0);
    return share_at_end(sum, view, way);
}
#include "shafts.glsl"
