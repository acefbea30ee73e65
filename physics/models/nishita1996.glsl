// Nishita's sky of several orders: light scattered before is kept in voxels, in eight directions in the plane of sun and zenith.
// What it is and leaves out: src/models/nishita1996.cpp. [NishitaEtAl1996]

// The directions: up, down; level towards the sun and away from it; the sun and opposite to it; across the sun, up and down.
// The cosine between direction j and a view with these cosines.
FN Number nishita1996_cosine(int j, Number mu, Number mu_s, Number nu) {
    Number sin_s = sqrt(max((1.0 - mu_s) * (1.0 + mu_s), Number(0.0)));
    Number level = sin_s > 1e-4 ? (nu - mu * mu_s) / sin_s : Number(0.0);
    Number c = mu;
    if (j / 2 == 1) c = level;
    if (j / 2 == 2) c = nu;
    if (j / 2 == 3) c = sin_s * mu - mu_s * level;
    if (j == 2 * (j / 2)) return clamp(c, Number(-1.0), Number(1.0));
    return clamp(-c, Number(-1.0), Number(1.0));
}

// What of the light around each of the eight directions is scattered into the view: the integral of either phase function over the
// directions nearest to each.
struct SampledPhases {
    Spectrum air[8];
    Spectrum aerosol[8];
};

// Voxels: altitude at equal steps of density, the sun's zenith angle, and the eight directions one after another.
FN PhaseSpectrum nishita1996_voxel(IN(ExponentialAir) air, IN(TABLE_3D(PhaseSpectrum)) voxels, int altitudes, int suns, Length h,
                                   Number mu_s, int j) {
    Number x = texture_coordinate(nishita1993_sphere_place(air.top, air.air_scale_height, h), altitudes);
    Number y = texture_coordinate(sun_coordinate(mu_s), suns);
    return look_up(voxels, TexCoord3(x, y, (Number(j) + 0.5) / 8.0));
}

// A sum of light scattered again along a path, and the depth of the path so far.
struct ScatteredAgain {
    PhaseSpectrum light;  // per unit of the sun's irradiance
    Spectrum depth;
};

FN void nishita1996_march(INOUT(ScatteredAgain) again, IN(ExponentialAir) air, IN(ScatteringSpectrum) air_scattering,
                          IN(ScatteringSpectrum) aerosol_scattering, IN(TABLE_3D(PhaseSpectrum)) voxels, int altitudes, int suns,
                          IN(SampledPhases) phases, IN(AirRay) ray, Length start, Length length, bool down, int steps) {
    for (int k = 0; k < steps; ++k) {
        Length t = start + crowded_middle(length, k, steps, down);
        Length step = crowded_step(length, k, steps, down);
        Length h = altitude_at(ray.altitude, ray.mu, t, air.bottom);
        Number mu_s = sun_cosine_at(ray.altitude, ray.mu_s, ray.nu, t, h, air.bottom);
        AirDensities density = air_densities(air, h);
        ScatteringSpectrum of_air = air_scattering * density.air;
        ScatteringSpectrum of_aerosol = aerosol_scattering * density.aerosol;
        PhasedScatteringSpectrum source = PhasedScatteringSpectrum(0.0 * per_sr / m);
        for (int j = 0; j < 8; ++j)
            source += (of_air * phases.air[j] + of_aerosol * phases.aerosol[j]) *
                      nishita1996_voxel(air, voxels, altitudes, suns, h, mu_s, j);
        AirColumns column;
        column.air = density.air * step;
        column.aerosol = density.aerosol * step;
        Spectrum step_depth = optical_depth(air, column);
        again.light += source * step * exp(-(again.depth + 0.5 * step_depth));
        again.depth += step_depth;
    }
}

// All light of the voxels that is scattered into a ray.
FN PhaseSpectrum nishita1996_light(IN(ExponentialAir) air, IN(ScatteringSpectrum) air_scattering,
                                   IN(ScatteringSpectrum) aerosol_scattering, IN(TABLE_3D(PhaseSpectrum)) voxels, int altitudes,
                                   int suns, IN(SampledPhases) phases, IN(AirRay) ray, int steps) {
    ScatteredAgain again;
    again.light = PhaseSpectrum(0.0 * per_sr);
    again.depth = Spectrum(0.0);
    Length perigee = clamp(-(air.bottom + ray.altitude) * ray.mu, 0.0 * m, ray.reach);
    if (perigee > 0.0 * m)
        nishita1996_march(again, air, air_scattering, aerosol_scattering, voxels, altitudes, suns, phases, ray, 0.0 * m, perigee, true,
                          steps);
    if (perigee < ray.reach)
        nishita1996_march(again, air, air_scattering, aerosol_scattering, voxels, altitudes, suns, phases, ray, perigee,
                          ray.reach - perigee, false, steps);
    return again.light;
}

// For tests: phases that are the same in all directions.
FN SampledPhases nishita1996_even_phases() {
    SampledPhases phases;
    for (int j = 0; j < 8; ++j) {
        phases.air[j] = Spectrum(0.125);
        phases.aerosol[j] = Spectrum(0.125);
    }
    return phases;
}
