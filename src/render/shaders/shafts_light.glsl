// What the methods of light shafts read of the table of light scattered once.
#include "shafts_table.glsl"
layout(binding = 11) uniform sampler3D even_light;    // over the way
layout(binding = 14) uniform sampler3D peaked_light;  // over the way and the peak

// A ray of the picture, ready for look-ups.
struct ShaftsView {
    vec2 place;  // in the table
    vec3 peak;
    float whole, power;
};

ShaftsView shafts_view(vec2 place, vec3 direction, AirRay start) {
    vec2 size = vec2(textureSize(even_light, 0).xy);
    return ShaftsView(0.5 / size + (0.5 * place + 0.5) * (1.0 - 1.0 / size), peak_towards(direction), whole_way(start), power_of(start));
}

// Light scattered once over a way from the start of the air.
vec3 light_over(ShaftsView view, float way) {
    float layers = float(textureSize(even_light, 0).z);
    float x = pow(clamp(way / view.whole, 0.0, 1.0), 1.0 / view.power);
    vec3 at = vec3(view.place, 0.5 / layers + x * (1.0 - 1.0 / layers));
    return way * (textureLod(even_light, at, 0.0).rgb + textureLod(peaked_light, at, 0.0).rgb * view.peak);
}

// The light of a ray's lit parts: look-ups are needed only where light and shadow meet.
struct LitSum {
    vec3 lit;      // up to where this part begins
    vec3 begun;    // all light up to there
    float share;   // of this part that is lit
};
LitSum lit_from_the_eye() { return LitSum(vec3(0.0), vec3(0.0), 1.0); }

// From a distance on, a share of the light is lit.
void go_on(inout LitSum sum, ShaftsView view, float way, float share) {
    if (share == sum.share) return;
    vec3 here = light_over(view, way);
    sum.lit += sum.share * (here - sum.begun);
    sum.begun = here;
    sum.share = share;
}

vec3 share_of(vec3 lit, vec3 all) { return clamp(mix(lit / max(all, 1e-30), vec3(1.0), lessThanEqual(all, vec3(1e-30))), 0.0, 1.0); }

vec3 share_at_end(LitSum sum, ShaftsView view, float way) {
    if (sum.share == 1.0 && sum.begun == vec3(0.0)) return vec3(1.0);
    vec3 all = light_over(view, way);
    return share_of(sum.lit + sum.share * (all - sum.begun), all);
}
