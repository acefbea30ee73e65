// What methods of air share that keep four wavelengths apart to the end. Stands behind air_view.glsl.
#include "air_wavelengths.glsl"
#define AirLight vec4

struct AirSeen {
    AirLight inscattered;
    AirLight transmittance;
    AirLight once;
};

vec3 colour_through(vec3 colour, AirLight seen) { return colour * colour_of(air.solar_irradiance * seen) / colour_of_sun.rgb; }

AirLight air_sunlight(float h, float mu_s) { return air.solar_irradiance * airlight_sunlight(transmittance, min(h, air.top), mu_s); }
