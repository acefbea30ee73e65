// How a surface of the geometry buffer reflects light towards the eye. Reads `pi`, which stands before this.

// Radiance towards the eye over the light that makes it.
struct SurfaceLight {
    vec3 of_sun;  // over the irradiance of the sun on a surface that faces it
    vec3 of_sky;  // over the irradiance of an even sky on level ground
};

const float mirror_of_water = 0.02;  // reflectance of still water at right angles

// Reflectance of still water for light that meets it at an angle of this cosine [Schlick1994].
float fresnel(float c) { return mirror_of_water + (1.0 - mirror_of_water) * pow(1.0 - clamp(c, 0.0, 1.0), 5.0); }

// The sun in water. Waves that the normal shows tilt it; those that are too small tilt it further, as a Gaussian of their slope with a mean
// square of roughness^2 [CoxMunk1954]. Slopes are those of level water, and so they add: seen together, pixels that show waves shine as
// those that do not.
float glint(vec3 n, vec3 up, vec3 view, vec3 to_sun, float roughness) {
    vec3 between = normalize(to_sun + view);
    float c = clamp(dot(up, between), 1e-2, 1.0), m = roughness * roughness;
    vec3 missing = between / c - n / max(dot(n, up), 1e-2);
    float slopes = exp(-dot(missing, missing) / m) / (pi * m * c * c * c * c);
    return fresnel(dot(view, between)) * slopes / (4.0 * max(dot(up, view), 0.05));
}

// material  roughness and water
// up        away from the planet's centre, there
// view      from the surface to the eye
SurfaceLight surface_light(vec3 reflectance, vec2 material, vec3 n, vec3 up, vec3 view, vec3 to_sun) {
    SurfaceLight light;
    float facing = max(dot(n, to_sun), 0.0);
    light.of_sun = reflectance / pi * facing;
    if (material.g > 0.0 && dot(up, to_sun) > 0.0) light.of_sun += vec3(material.g * glint(n, up, view, to_sun, material.r));
    light.of_sky = reflectance / pi * (0.5 + 0.5 * dot(n, up));
    return light;
}
