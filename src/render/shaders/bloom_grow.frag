#version 450 core
// Twice the size, by linear filtering.
layout(binding = 0) uniform sampler2D light;
layout(location = 0) out vec4 twice_the_size;
void main() { twice_the_size = textureLod(light, 0.5 * gl_FragCoord.xy / vec2(textureSize(light, 0)), 0.0); }
