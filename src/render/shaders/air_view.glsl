// What every method of air is told of a frame (src/render/air_pass.h). Textures of a method stand at bindings from 8 on, its uniform
// blocks at 1 and from 3 on.
#include "physics/readings/glsl.glsl"
#include "physics/shell.glsl"
layout(std140, binding = 2) uniform AirView {
    vec4 eye_up;             // away from the planet's centre, of length one; the eye's altitude
    vec4 towards_sun;        // of length one; the angular radius of the sun's disk
    vec4 air_shell;          // radius of the ground, altitude of the top
    vec4 colour_of_sun;      // of its light above the air, on a surface that faces it
    vec4 limb_darkening[2];  // in each colour
    vec4 ground_albedo;      // of the ground sphere
};

// The angle between two directions of length one. Not by acos, which near 0 is off by the root of its argument's rounding.
float angle_between(vec3 a, vec3 b) { return atan(length(cross(a, b)), dot(a, b)); }

// The part within the air of a ray from the eye.
struct AirRay {
    float h;      // altitude of its start
    float mu;     // zenith cosines of the ray and of the sun there
    float mu_s;
    float nu;     // cosine between ray and sun
    float empty;  // distance of its start from the eye
};

// False if the ray does not meet the air.
bool enter_air(vec3 direction, out AirRay ray) {
    vec3 up = eye_up.xyz;
    float bottom = air_shell.x, top = air_shell.y;
    ray = AirRay(max(eye_up.w, 0.0), dot(direction, up), dot(up, towards_sun.xyz), dot(direction, towards_sun.xyz), 0.0);
    if (ray.h <= top) return true;
    float r = bottom + ray.h, r_top = bottom + top;
    float beside = r * length(cross(direction, up));  // how far from the centre it passes
    float inside = (r_top - beside) * (r_top + beside);
    if (ray.mu >= 0.0 || inside <= 0.0) return false;
    float way = (ray.h - top) * (r + r_top) / (sqrt(inside) - r * ray.mu);
    ray = AirRay(top, -sqrt(inside) / r_top, clamp((r * ray.mu_s + ray.nu * way) / r_top, -1.0, 1.0), ray.nu, way);
    return true;
}
