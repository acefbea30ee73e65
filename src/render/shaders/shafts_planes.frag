#version 450 core
// Light shafts on sampling planes [Dobashi2002]: all rays are asked at the same planes across the camera's axis, and where two planes
// disagree sub-planes between them say where the shadow begins. Approximates: shadows that begin and end between two planes are missed,
// and edges of what is found lie on sub-planes, an eighth as far apart. Cost: 32 looks at the shadow maps, 3 for each edge, and as many
// at the table of light scattered once as a ray has edges.
#include "camera.glsl"
#include "shafts_light.glsl"

const int planes = 32, halvings = 3;

vec3 lit_share(vec2 place, vec3 direction, AirRay start, float way) {
    ShaftsView view = shafts_view(place, start);
    // Planes crowd towards the eye, or the air, out to where shadows end.
    float slant = dot(direction, camera_forward.xyz), nearest = start.empty * slant;
    float depth = max(min(shadows_end(), 1e7) - nearest, 1.0);
    vec3 lit = vec3(0.0), begun = vec3(0.0);
    bool seen = sun_sees(direction * start.empty);
    float from = 0.0;
    for (int i = 1; i <= planes && from < way; ++i) {
        float t = float(i) / float(planes), to = min(depth * (t * t) * (t * t) / slant, way);
        bool seen_there = sun_sees(direction * (start.empty + to));
        if (seen_there != seen) {
            float low = from, high = to;
            for (int k = 0; k < halvings; ++k) {
                float middle = 0.5 * (low + high);
                if (sun_sees(direction * (start.empty + middle)) == seen) low = middle;
                else high = middle;
            }
            vec3 light = light_over(view, 0.5 * (low + high));
            if (seen) lit += light - begun;
            begun = light;
            seen = seen_there;
        }
        from = to;
    }
    vec3 all = light_over(view, way);
    if (seen) lit += all - begun;
    return share_of(lit, all);
}
#include "shafts.glsl"
