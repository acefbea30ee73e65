#version 450 core
// Two pictures of the same view: one beside the other, or by how much the second differs from the first.
layout(std140, binding = 1) uniform Comparing {
    vec4 luminance_of_rgb;
    int difference;  // 0: side by side
    float edge;      // side by side, from 0 (left) to 1: the first is to the left of it
    float span;      // difference: the share of luminance whose colour is full
};
layout(binding = 0) uniform sampler2D first;
layout(binding = 1) uniform sampler2D second;
layout(location = 0) in vec2 place;
layout(location = 0) out vec4 compared;

// White where both are as bright; red where the second is brighter, blue where it is darker.
vec3 colour_of(float share) {
    float full = clamp(abs(share) / span, 0.0, 1.0);
    return mix(vec3(1.0), share > 0.0 ? vec3(0.8, 0.05, 0.05) : vec3(0.05, 0.15, 0.8), full);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 a = texelFetch(first, pixel, 0).rgb, b = texelFetch(second, pixel, 0).rgb;
    if (difference == 0) {
        compared = vec4(0.5 + 0.5 * place.x < edge ? a : b, 1.0);
        return;
    }
    float bright = dot(a, luminance_of_rgb.rgb), other = dot(b, luminance_of_rgb.rgb);
    compared = vec4(colour_of(bright == other ? 0.0 : (other - bright) / max(bright, 1e-6)), 1.0);
}
