// What the methods of light shafts read of the table of light scattered once.
#include "shafts_table.glsl"
layout(binding = 11) uniform sampler3D once_scattered;

// A ray of the picture, ready for look-ups.
struct ShaftsView {
    vec2 place;  // in the table
    float whole, power;
};

ShaftsView shafts_view(vec2 place, AirRay start) {
    vec2 size = vec2(textureSize(once_scattered, 0).xy);
    return ShaftsView(0.5 / size + (0.5 * place + 0.5) * (1.0 - 1.0 / size), whole_way(start), power_of(start));
}

// Light scattered once over a way from the start of the air.
vec3 light_over(ShaftsView view, float way) {
    float layers = float(textureSize(once_scattered, 0).z);
    float x = pow(clamp(way / view.whole, 0.0, 1.0), 1.0 / view.power);
    return textureLod(once_scattered, vec3(view.place, 0.5 / layers + x * (1.0 - 1.0 / layers)), 0.0).rgb;
}

vec3 share_of(vec3 lit, vec3 all) { return clamp(mix(lit / max(all, 1e-30), vec3(1.0), lessThanEqual(all, vec3(1e-30))), 0.0, 1.0); }
