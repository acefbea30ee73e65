#version 450 core
// The light between the stars, where neither sun nor moon is near.
#include "camera.glsl"
#include "background.glsl"
#include "night_sky.glsl"
layout(location = 0) in vec2 place;
layout(location = 0) out vec4 radiance;

void main() { radiance = vec4(night_sky_at(normalize(view_ray(place))), 1.0); }
