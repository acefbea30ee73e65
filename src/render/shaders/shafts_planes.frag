#version 450 core
// Light shafts on sampling planes [Dobashi2002]: all rays are asked at the same planes across the camera's axis, and where two planes
// disagree sub-planes between them say where the shadow begins. Approximates: shadows that begin and end between two planes are missed,
// and edges of what is found lie on sub-planes, an eighth as far apart. Cost: 32 looks at the shadow maps, 3 for each edge, and as many
// at the table of light scattered once as a ray has edges.
#include "camera.glsl"
#include "shafts_light.glsl"

const int planes = 32, halvings = 3;

vec3 lit_share(vec2 place, vec3 direction, AirRay start, float way, vec2 part) {
    ShaftsView view = shafts_view(place, direction, start);
    LitSum sum = lit_from_the_eye();
    // Planes crowd towards the eye, or the air, out to where shadows end.
    float slant = dot(direction, camera_forward.xyz), nearest = start.empty * slant;
    float depth = max(cascade_depth[shadow_count.x - 1].z - nearest, 1.0), from = part.x;
    bool seen = sun_sees(direction, start.empty + from);
    go_on(sum, view, from, seen ? 1.0 : 0.0);
    for (int i = 1; i <= planes && from < part.y; ++i) {
        float t = float(i) / float(planes), to = min(depth * (t * t) * (t * t) / slant, part.y);
        if (to <= from) continue;
        bool seen_there = sun_sees(direction, start.empty + to);
        if (seen_there != seen) {
            float low = from, high = to;
            for (int k = 0; k < halvings; ++k) {
                float middle = 0.5 * (low + high);
                if (sun_sees(direction, start.empty + middle) == seen) low = middle;
                else high = middle;
            }
            seen = seen_there;
            go_on(sum, view, 0.5 * (low + high), seen ? 1.0 : 0.0);
        }
        from = to;
    }
    go_on(sum, view, part.y, 1.0);
    return share_at_end(sum, view, way);
}
#include "shafts.glsl"
