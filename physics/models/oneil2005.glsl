// O'Neil's second sky: optical lengths from a formula fitted to the table of the first, so that no texture is needed.
// What it is and leaves out: src/models/oneil2005.cpp. [ONeil2005]

// The column of a constituent from the ground to the top over its scale height: e^(a + b x + c x^2 + d x^3 + e x^4), x = 1 - mu.
struct ScaleFunction {
    Number a;
    Number b;
    Number c;
    Number d;
    Number e;
};

FN ScaleFunction scale_function(Number a, Number b, Number c, Number d, Number e) {
    ScaleFunction f;
    f.a = a;
    f.b = b;
    f.c = c;
    f.d = d;
    f.e = e;
    return f;
}

// For rays that do not go down.
FN Number scale_of(IN(ScaleFunction) f, Number mu) {
    Number x = 1.0 - mu;
    return exp(f.a + x * (f.b + x * (f.c + x * (f.d + x * f.e))));
}

// The column to the top from an altitude. A ray that goes down passes its perigee and is the same beyond: twice the level ray
// there, less the ray that rises from here. (The published polynomial was let run on.)
FN Length oneil2005_column(IN(ScaleFunction) f, Length scale_height, Length bottom, Length h, Number mu) {
    Length rising = scale_height * (exponential_density(h, scale_height) * scale_of(f, abs(mu)));
    if (mu >= 0.0) return rising;
    Length r = bottom + h;
    // r (1 - sin z) of the zenith angle z, without the difference of two radii.
    Length perigee = h - r * (mu * mu / (1.0 + sqrt((1.0 - mu) * (1.0 + mu))));
    Length level = scale_height * (exponential_density(max(perigee, 0.0 * m), scale_height) * scale_of(f, Number(0.0)));
    return 2.0 * level - rising;
}

// The fit for one planet: both constituents' scale functions.
struct ONeil2005 {
    ScaleFunction air;
    ScaleFunction aerosol;
};

FN ONeil2005 oneil2005(IN(ScaleFunction) air, IN(ScaleFunction) aerosol) {
    ONeil2005 fit;
    fit.air = air;
    fit.aerosol = aerosol;
    return fit;
}

FN AirColumns oneil2005_columns(IN(ExponentialAir) air, IN(ONeil2005) fit, Length h, Number mu) {
    AirColumns column;
    column.air = oneil2005_column(fit.air, air.air_scale_height, air.bottom, h, mu);
    column.aerosol = oneil2005_column(fit.aerosol, air.aerosol_scale_height, air.bottom, h, mu);
    return column;
}

FN AirColumns oneil2005_between(IN(ExponentialAir) air, IN(ONeil2005) fit, IN(AirRay) ray, Length h, Number mu) {
    if (mu >= 0.0)
        return oneil_difference(oneil2005_columns(air, fit, ray.altitude, ray.mu), oneil2005_columns(air, fit, h, mu));
    return oneil_difference(oneil2005_columns(air, fit, h, -mu), oneil2005_columns(air, fit, ray.altitude, -ray.mu));
}

FN ScatteredLight oneil2005_light(IN(ExponentialAir) air, IN(ONeil2005) fit, IN(AirRay) ray, int samples) {
    ScatteredLight light = no_scattered_light();
    Length step = ray.reach / Number(samples);
    for (int k = 0; k <= samples; ++k) {
        Length t = k < samples ? (Number(k) + 0.5) * step : ray.reach;
        Length h = altitude_at(ray.altitude, ray.mu, t, air.bottom);
        Number mu = cosine_at(ray.altitude, ray.mu, t, h, air.bottom);
        Number mu_s = sun_cosine_at(ray.altitude, ray.mu_s, ray.nu, t, h, air.bottom);
        light.depth = optical_depth(air, oneil2005_between(air, fit, ray, h, mu));
        if (k == samples || meets_ground(h, mu_s, air.bottom)) continue;
        oneil_sample(light, light.depth + optical_depth(air, oneil2005_columns(air, fit, h, mu_s)), air_densities(air, h), step);
    }
    return light;
}
