#version 450 core
// The picture as a display shows it: exposed, with bloom, within the display's colours, bent by a tone curve, encoded and dithered.
layout(std140, binding = 1) uniform ToneSettings {
    vec4 luminance_of_rgb;
    int curve;
    float bloom;  // the share of light that is spread
};
#include "tone.glsl"
layout(binding = 0) uniform sampler2D radiance;
layout(binding = 1) uniform sampler2D spread;  // half the size, rounded up; the corner of its first texel is the picture's
layout(std430, binding = 1) readonly buffer Exposure { float exposure; };
layout(location = 0) out vec4 level;

void main() {
    ivec2 size = textureSize(radiance, 0), pixel = ivec2(gl_FragCoord.xy);
    vec3 light = texelFetch(radiance, pixel, 0).rgb;
    if (bloom > 0.0) light = mix(light, textureLod(spread, 0.5 * gl_FragCoord.xy / vec2(textureSize(spread, 0)), 0.0).rgb, bloom);
    vec3 display = tone(curve, exposure * into_gamut(light));
    level = vec4(level_of(display, uvec2(pixel.x, size.y - 1 - pixel.y)), 1.0);
}
