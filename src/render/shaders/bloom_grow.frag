#version 450 core
// Twice the size: each way a quadratic spline over three texels, so that what is small grows round.
layout(binding = 0) uniform sampler2D light;
layout(location = 0) out vec4 twice_the_size;

void main() {
    vec2 at = 0.5 * gl_FragCoord.xy, size = vec2(textureSize(light, 0));
    twice_the_size = vec4(0.0);
    for (int i = 0; i < 4; ++i) twice_the_size += 0.25 * textureLod(light, (at + vec2(i % 2, i / 2) - 0.5) / size, 0.0);
}
