// Air as the models of single scattering have it: two constituents whose densities fall exponentially, molecules ("air") and
// aerosol, and light scattered once on its way along a ray. [Kaneda1991; NishitaEtAl1993]

struct ExponentialAir {
    Length bottom;  // radius of the ground
    Length top;     // altitude above which there is nothing
    Length air_scale_height;
    Length aerosol_scale_height;
    ScatteringSpectrum air_extinction;  // at the ground
    ScatteringSpectrum aerosol_extinction;
};

FN ExponentialAir exponential_air(Length bottom, Length top, Length air_scale_height, Length aerosol_scale_height,
                                  IN(ScatteringSpectrum) air_extinction, IN(ScatteringSpectrum) aerosol_extinction) {
    ExponentialAir air;
    air.bottom = bottom;
    air.top = top;
    air.air_scale_height = air_scale_height;
    air.aerosol_scale_height = aerosol_scale_height;
    air.air_extinction = air_extinction;
    air.aerosol_extinction = aerosol_extinction;
    return air;
}

// A ray from a point within the air: cosines of the zenith angles of the ray and of the sun and of the angle between them; it ends
// after `reach`, which lies within the air and does not pass the ground.
struct AirRay {
    Length altitude;
    Number mu;
    Number mu_s;
    Number nu;
    Length reach;
};

FN AirRay air_ray(Length altitude, Number mu, Number mu_s, Number nu, Length length) {
    AirRay ray;
    ray.altitude = altitude;
    ray.mu = mu;
    ray.mu_s = mu_s;
    ray.nu = nu;
    ray.reach = length;
    return ray;
}

// Distance along a ray to the ground or the top.
FN Length distance_in_air(IN(ExponentialAir) air, Length h, Number mu) {
    return meets_ground(h, mu, air.bottom) ? distance_to_ground(h, mu, air.bottom) : distance_to_top(h, mu, air.bottom, air.top);
}

// Of each constituent: a relative density, or its integral along a path.
struct AirDensities {
    Number air;
    Number aerosol;
};
struct AirColumns {
    Length air;
    Length aerosol;
};

FN AirDensities air_densities(IN(ExponentialAir) air, Length h) {
    AirDensities density;
    density.air = exponential_density(h, air.air_scale_height);
    density.aerosol = exponential_density(h, air.aerosol_scale_height);
    return density;
}

FN Spectrum optical_depth(IN(ExponentialAir) air, IN(AirColumns) column) {
    return air.air_extinction * column.air + air.aerosol_extinction * column.aerosol;
}

// Light that was scattered once along a path, for each constituent the integral of its density times the transmittance from the
// sun and to the eye: times scattering coefficient, phase function and the sun's irradiance it is radiance.
struct ScatteredLight {
    LengthSpectrum air;
    LengthSpectrum aerosol;
    Spectrum depth;  // of the path
};

FN ScatteredLight no_scattered_light() {
    ScatteredLight light;
    light.air = LengthSpectrum(0.0 * m);
    light.aerosol = LengthSpectrum(0.0 * m);
    light.depth = Spectrum(0.0);
    return light;
}

// A step of a march away from the eye: `step` of air of one density, lit by what comes through from the sun.
FN void add_step(INOUT(ScatteredLight) light, IN(ExponentialAir) air, IN(AirDensities) density, Length step, IN(Spectrum) sunlight) {
    AirColumns column;
    column.air = density.air * step;
    column.aerosol = density.aerosol * step;
    Spectrum step_depth = optical_depth(air, column);
    Spectrum seen = exp(-(light.depth + 0.5 * step_depth)) * sunlight;
    light.air += seen * column.air;
    light.aerosol += seen * column.aerosol;
    light.depth += step_depth;
}
