#version 450 core
// A star as a point two pixels wide, where it is seen through the air.
#include "camera.glsl"
#include "background.glsl"
layout(std430, binding = 0) readonly buffer Stars { vec4 stars[]; };  // direction; illuminance in red, green and blue
layout(location = 0) flat out vec2 centre;                           // in pixels
layout(location = 1) flat out vec3 radiance_of_pixel;                // if all its light fell into one

// The elevation at which something is seen that stands at another.
float apparent_elevation(float elevation) {
    float low = elevation, high = 0.5 * pi;
    for (int i = 0; i < 20; ++i) {
        float middle = 0.5 * (low + high);
        if (middle - bending_at(middle) < elevation) low = middle;
        else high = middle;
    }
    return high;
}

void main() {
    vec3 direction = stars[2 * gl_VertexID].xyz;
    float elevation = elevation_of(direction), seen_at = apparent_elevation(elevation);
    bool hidden = seen_at < eye_up.w || (towards_moon.w > 0.0 && angle_between(direction, towards_moon.xyz) < towards_moon.w) ||
                  angle_between(direction, towards_sun.xyz) < towards_sun.w;
    vec3 seen = raised(direction, seen_at - elevation);
    vec4 clip = clip_position(seen);
    float ahead = clip.w;
    gl_PointSize = 2.0;
    gl_Position = hidden ? vec4(0.0, 0.0, 0.0, -1.0) : vec4(clip.xy, 0.0, ahead);
    centre = (0.5 * gl_Position.xy / gl_Position.w + 0.5) * pixel.yz;
    // A pixel beside the middle spans less of the sky.
    radiance_of_pixel = stars[2 * gl_VertexID + 1].rgb / (pixel.x * pixel.x * ahead * ahead * ahead);
}
