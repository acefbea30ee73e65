// How a surface of the geometry buffer reflects light towards the eye. Reads `pi`, which stands before this.

// Radiance towards the eye over the light that makes it.
struct SurfaceLight {
    vec3 of_sun;  // over the irradiance of the sun on a surface that faces it
    vec3 of_sky;  // over the irradiance of an even sky on level ground
};

const float mirror_of_water = 0.02;  // reflectance of still water at right angles

// The sun in water whose waves tilt as a Gaussian of their slope does, with a mean square of roughness^2 / 2 [CoxMunk1954].
float glint(vec3 n, vec3 view, vec3 to_sun, float roughness) {
    vec3 between = normalize(to_sun + view);
    float c = clamp(dot(n, between), 1e-2, 1.0), m = roughness * roughness;
    float slopes = exp((1.0 - 1.0 / (c * c)) / m) / (pi * m * c * c * c * c);
    float fresnel = mirror_of_water + (1.0 - mirror_of_water) * pow(1.0 - clamp(dot(view, between), 0.0, 1.0), 5.0);
    return fresnel * slopes / (4.0 * max(dot(n, view), 0.05));
}

// material  roughness and water
// up        away from the planet's centre, there
// view      from the surface to the eye
SurfaceLight surface_light(vec3 reflectance, vec2 material, vec3 n, vec3 up, vec3 view, vec3 to_sun) {
    SurfaceLight light;
    float facing = max(dot(n, to_sun), 0.0);
    light.of_sun = reflectance / pi * facing;
    if (facing > 0.0 && material.g > 0.0) light.of_sun += vec3(material.g * glint(n, view, to_sun, material.r));
    light.of_sky = reflectance / pi * (0.5 + 0.5 * dot(n, up));
    return light;
}
