// How a surface of the geometry buffer reflects light towards the eye. Reads `pi`, which stands before this.

// Radiance towards the eye over the light that makes it.
struct SurfaceLight {
    vec3 of_sun;  // over the irradiance of the sun on a surface that faces it
    vec3 of_sky;  // over the irradiance of an even sky on level ground
};

// Reflectance of still water for light that meets it at an angle of this cosine: Fresnel's equations, both polarizations alike.
float fresnel(float c) {
    const float index = 1.33;
    float inner = sqrt(1.0 - (1.0 - c * c) / (index * index));
    float across = (c - index * inner) / (c + index * inner), along = (index * c - inner) / (index * c + inner);
    return 0.5 * (across * across + along * along);
}

// The sun in water. Waves that the normal shows tilt it; those that are too small tilt it further, as a Gaussian of their slope with a mean
// square of roughness^2 [CoxMunk1954]. Slopes are those of level water, and so they add: seen together, pixels that show waves shine as
// those that do not.
float glint(vec3 n, vec3 up, vec3 view, vec3 to_sun, float roughness) {
    vec3 between = normalize(to_sun + view);
    float c = clamp(dot(up, between), 1e-2, 1.0), m = roughness * roughness;
    vec3 missing = between / c - n / max(dot(n, up), 1e-2);
    float slopes = exp(-dot(missing, missing) / m) / (pi * m * c * c * c * c);
    return fresnel(clamp(dot(view, between), 0.0, 1.0)) * slopes / (4.0 * max(dot(up, view), 0.05));
}

// What water mirrors of the sky, and from where.
struct Mirror {
    vec3 direction;  // above the horizon
    float share;     // of the radiance from there
};

// In the mean of the waves that the normal does not show and the eye sees: fits of sums over Gaussian slopes [CoxMunk1954], of a roughness up
// to 0.2. Shares are within 5 % of the sums, sines of the direction above the horizon within 21 %, at 0 to 89.7 degrees from the normal.
Mirror mirror_of(vec3 n, vec3 up, vec3 view, float roughness) {
    float slope = max(roughness * sqrt(0.5), 1e-3), c = clamp(dot(n, view), 0.0, 1.0);
    Mirror mirror;
    mirror.share = fresnel(min(c + 1.1 * slope * exp(-0.7 * c / slope), 1.0)) * (1.0 + 26.0 * slope * slope * c * (1.0 - c));
    vec3 still = reflect(-view, n);
    float rise = dot(still, up), x = max((1.0 - 8.0 * slope * slope) * abs(rise), 1e-3), y = 1.9 * slope, sine = pow(x * x * x + y * y * y, 1.0 / 3.0);
    vec3 level = still - rise * up;
    mirror.direction = sine * up + sqrt(1.0 - min(sine * sine, 1.0)) * level / max(length(level), 1e-6);
    return mirror;
}

// material  roughness and water
// up        away from the planet's centre, there
// view      from the surface to the eye
SurfaceLight surface_light(vec3 reflectance, vec2 material, vec3 n, vec3 up, vec3 view, vec3 to_sun) {
    SurfaceLight light;
    float facing = max(dot(n, to_sun), 0.0);
    light.of_sun = reflectance / pi * facing;
#ifndef AIR_WITHOUT_WATER
    if (material.g > 0.0 && dot(up, to_sun) > 0.0) light.of_sun += vec3(material.g * glint(n, up, view, to_sun, material.r));
#endif
    light.of_sky = reflectance / pi * (0.5 + 0.5 * dot(n, up));
    return light;
}
