#version 450 core
// Half the size: each way the weights 1, 3, 3, 1 over 8. Every texel gives as much as the next: no light is lost, save over edges.
layout(binding = 0) uniform sampler2D light;
layout(location = 0) out vec4 half_size;

void main() {
    // Linear filtering a quarter from a texel's middle weighs two texels 3 to 1.
    vec2 corner = 2.0 * gl_FragCoord.xy, size = vec2(textureSize(light, 0));
    half_size = vec4(0.0);
    for (int i = 0; i < 4; ++i) half_size += 0.25 * textureLod(light, (corner + vec2(i % 2, i / 2) * 1.5 - 0.75) / size, 0.0);
}
