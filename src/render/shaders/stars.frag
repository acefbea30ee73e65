#version 450 core
// The share of a star's light that falls into a pixel: shares of the four pixels around it add up to one wherever it stands.
layout(location = 0) flat in vec2 centre;
layout(location = 1) flat in vec3 radiance_of_pixel;
layout(location = 0) out vec4 radiance;

void main() {
    vec2 share = max(1.0 - abs(gl_FragCoord.xy - centre), 0.0);
    radiance = vec4(radiance_of_pixel * (share.x * share.y), 0.0);
}
