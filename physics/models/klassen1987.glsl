// Klassen's sky: two shells of constant density, light scattered once in the lower one; and his thin layer of fog.
// What it is and leaves out: src/models/klassen1987.cpp. [Klassen1987]

struct KlassenLayers {
    Length haze_top;
    Length air_top;
    AirDensities haze;  // relative to the ground's
    Number upper;       // of the molecules above the haze
};

FN KlassenLayers klassen1987_layers(Length haze_top, Length air_top, Number haze_air, Number haze_aerosol, Number upper) {
    KlassenLayers layers;
    layers.haze_top = haze_top;
    layers.air_top = air_top;
    layers.haze.air = haze_air;
    layers.haze.aerosol = haze_aerosol;
    layers.upper = upper;
    return layers;
}

// The part of a ray that lies in the shell between the ground and `top`: where it begins, and how long it is.
struct ShellPath {
    Length start;
    Length within;
};
FN ShellPath path_in_shell(Length h, Number mu, Length bottom, Length top, Length limit) {
    ShellPath path;
    path.start = 0.0 * m;
    path.within = 0.0 * m;
    Length inside = h;
    Number mu_inside = mu;
    if (h > top) {
        if (!meets_ground(h - top, mu, bottom + top)) return path;
        path.start = min(distance_to_ground(h - top, mu, bottom + top), limit);
        inside = top;
        mu_inside = cosine_at(h, mu, path.start, top, bottom);
    }
    Length end = meets_ground(h, mu, bottom) ? distance_to_ground(h, mu, bottom)
                                             : path.start + distance_to_top(inside, mu_inside, bottom, top);
    path.within = max(min(end, limit) - path.start, 0.0 * m);
    return path;
}

FN Spectrum klassen1987_depth(IN(ExponentialAir) air, IN(KlassenLayers) layers, Length in_haze, Length above) {
    AirColumns column;
    column.air = layers.haze.air * in_haze + layers.upper * above;
    column.aerosol = layers.haze.aerosol * in_haze;
    return optical_depth(air, column);
}

FN Spectrum klassen1987_sunlight(IN(ExponentialAir) air, IN(KlassenLayers) layers, Length h, Number mu_s) {
    if (meets_ground(h, mu_s, air.bottom)) return Spectrum(0.0);
    Length whole = distance_to_top(h, mu_s, air.bottom, layers.air_top);
    Length in_haze = path_in_shell(h, mu_s, air.bottom, layers.haze_top, whole).within;
    return exp(-klassen1987_depth(air, layers, in_haze, whole - in_haze));
}

// The ray lies below layers.air_top.
FN ScatteredLight klassen1987_light(IN(ExponentialAir) air, IN(KlassenLayers) layers, IN(AirRay) ray, int samples) {
    ScatteredLight light = no_scattered_light();
    ShellPath path = path_in_shell(ray.altitude, ray.mu, air.bottom, layers.haze_top, ray.reach);
    light.depth = klassen1987_depth(air, layers, 0.0 * m, path.start);
    Length step = path.within / Number(samples);
    for (int k = 0; k < samples; ++k) {
        Length t = path.start + (Number(k) + 0.5) * step;
        Length h = min(altitude_at(ray.altitude, ray.mu, t, air.bottom), layers.haze_top);
        Number mu_s = sun_cosine_at(ray.altitude, ray.mu_s, ray.nu, t, h, air.bottom);
        add_step(light, air, layers.haze, step, klassen1987_sunlight(air, layers, h, mu_s));
    }
    light.depth += klassen1987_depth(air, layers, 0.0 * m, max(ray.reach - path.start - path.within, 0.0 * m));
    return light;
}
