// Four wavelengths of the model `airlight`: its tables and the colours that its light stands for (src/render/air_wavelengths.h).
#include "physics/readings/glsl.glsl"
#include "physics/shell.glsl"
#include "physics/maps.glsl"
#include "physics/models/airlight_air.glsl"
#include "physics/models/airlight.glsl"
layout(binding = 8) uniform sampler2D densities;
layout(binding = 9) uniform sampler2D transmittance;
layout(binding = 10) uniform sampler3D source;
layout(binding = 11) uniform sampler2D diffuse;
layout(binding = 12) uniform sampler2D phases;  // [constituent][sample], even in the root of the scattering angle
layout(std140, binding = 3) uniform AirColours {
    vec4 colour_of_wavelength[4];
    vec4 darkening_of_wavelength[2];  // of the sun's limb
};

vec3 colour_of(Spectrum light) {
    vec3 sum = vec3(0.0);
    for (int w = 0; w < N; ++w) sum += light[w] * colour_of_wavelength[w].rgb;
    return sum;
}

PhaseSpectrum phase_of(int part, float angle) {
    float x = texture_coordinate(sqrt(angle / pi), textureSize(phases, 0).x);
    return look_up(phases, vec2(x, (float(part) + 0.5) / float(airlight_parts)));
}
