// O'Neil's first sky: one table of optical lengths for every ray to the top, a few samples of equal length.
// What it is and leaves out: src/models/oneil2004.cpp. [ONeil2004]

// Table: altitude along x, the ray's zenith angle along y (0 to 1: 0 to pi); texels hold the density of the air, its column to
// the top in m, and the same of the aerosol.
FN Spectrum oneil2004_texel(IN(TABLE_2D(Spectrum)) table, int altitudes, int angles, Length top, Length h, Number mu) {
    Number x = texture_coordinate(clamp(h / top, Number(0.0), Number(1.0)), altitudes);
    Number y = texture_coordinate(angle_of_cosine(clamp(mu, Number(-1.0), Number(1.0))) / pi, angles);
    return look_up(table, TexCoord2(x, y));
}

FN AirColumns oneil2004_columns(IN(TABLE_2D(Spectrum)) table, int altitudes, int angles, Length top, Length h, Number mu) {
    Spectrum texel = oneil2004_texel(table, altitudes, angles, top, h, mu);
    AirColumns column;
    column.air = texel[1] * m;
    column.aerosol = texel[3] * m;
    return column;
}

// The columns from the eye to a sample: those to the top of one less those of the other, taken the way in which the sample's
// ray rises, so that the ground does not matter.
FN AirColumns oneil_difference(IN(AirColumns) longer, IN(AirColumns) shorter) {
    AirColumns column;
    column.air = max(longer.air - shorter.air, 0.0 * m);
    column.aerosol = max(longer.aerosol - shorter.aerosol, 0.0 * m);
    return column;
}
FN AirColumns oneil2004_between(IN(TABLE_2D(Spectrum)) table, int altitudes, int angles, Length top, IN(AirRay) ray, Length h,
                                Number mu) {
    if (mu >= 0.0)
        return oneil_difference(oneil2004_columns(table, altitudes, angles, top, ray.altitude, ray.mu),
                                oneil2004_columns(table, altitudes, angles, top, h, mu));
    return oneil_difference(oneil2004_columns(table, altitudes, angles, top, h, -mu),
                            oneil2004_columns(table, altitudes, angles, top, ray.altitude, -ray.mu));
}

// Adds a sample in the middle of `step`, seen through one depth and lit through another.
FN void oneil_sample(INOUT(ScatteredLight) light, IN(Spectrum) depths, IN(AirDensities) density, Length step) {
    Spectrum seen = exp(-depths);
    light.air += seen * (density.air * step);
    light.aerosol += seen * (density.aerosol * step);
}

FN ScatteredLight oneil2004_light(IN(ExponentialAir) air, IN(TABLE_2D(Spectrum)) table, int altitudes, int angles, IN(AirRay) ray,
                                  int samples) {
    ScatteredLight light = no_scattered_light();
    Length step = ray.reach / Number(samples);
    for (int k = 0; k <= samples; ++k) {
        Length t = k < samples ? (Number(k) + 0.5) * step : ray.reach;
        Length h = altitude_at(ray.altitude, ray.mu, t, air.bottom);
        Number mu = cosine_at(ray.altitude, ray.mu, t, h, air.bottom);
        Number mu_s = sun_cosine_at(ray.altitude, ray.mu_s, ray.nu, t, h, air.bottom);
        light.depth = optical_depth(air, oneil2004_between(table, altitudes, angles, air.top, ray, h, mu));
        if (k == samples || meets_ground(h, mu_s, air.bottom)) continue;
        Spectrum texel = oneil2004_texel(table, altitudes, angles, air.top, h, mu_s);
        AirDensities density;
        density.air = texel[0];
        density.aerosol = texel[2];
        AirColumns sunward;
        sunward.air = texel[1] * m;
        sunward.aerosol = texel[3] * m;
        oneil_sample(light, light.depth + optical_depth(air, sunward), density, step);
    }
    return light;
}
