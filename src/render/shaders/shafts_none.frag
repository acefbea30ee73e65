#version 450 core
// No light shafts: the air is lit whatever stands before the sun, surfaces are not. Costs no more than the shadows on surfaces.
#include "camera.glsl"
#include "shadow.glsl"
layout(binding = 0) uniform sampler2D depth_buffer;
layout(location = 0) in vec2 place;
layout(location = 0) out vec4 shade;

void main() {
    float depth = texelFetch(depth_buffer, ivec2(gl_FragCoord.xy), 0).r;
    shade = vec4(vec3(1.0), depth > 0.0 ? sun_visibility(position_at(place, depth)) : 1.0);
}
