// Kaneda's sky: a march along the view, and at each of its samples a march towards the sun.
// What it is and leaves out: src/models/kaneda1991.cpp. [Kaneda1991]

// Rays are cut at their perigee; samples crowd quadratically towards the lower end of each piece, where the aerosol is. Their
// middles and lengths, for step k of n: `down` says that the piece ends at its lower end.
FN Length crowded_middle(Length length, int k, int n, bool down) {
    Number u = (Number(k) + 0.5) / Number(n);
    return down ? length * (u * (2.0 - u)) : length * (u * u);
}
FN Length crowded_step(Length length, int k, int n, bool down) {
    Number from_low = down ? Number(n - 1 - k) : Number(k);
    return length * ((2.0 * from_low + 1.0) / (Number(n) * Number(n)));
}

// The columns of a piece that begins at distance `start` of a ray.
FN AirColumns kaneda1991_piece(IN(ExponentialAir) air, Length h, Number mu, Length start, Length length, bool down, int steps) {
    AirColumns sum;
    sum.air = 0.0 * m;
    sum.aerosol = 0.0 * m;
    for (int k = 0; k < steps; ++k) {
        Length t = start + crowded_middle(length, k, steps, down);
        AirDensities density = air_densities(air, altitude_at(h, mu, t, air.bottom));
        Length step = crowded_step(length, k, steps, down);
        sum.air += density.air * step;
        sum.aerosol += density.aerosol * step;
    }
    return sum;
}

// The columns along a whole ray of a length.
FN AirColumns kaneda1991_columns(IN(ExponentialAir) air, Length h, Number mu, Length length, int steps) {
    Length perigee = clamp(-(air.bottom + h) * mu, 0.0 * m, length);
    AirColumns sum = kaneda1991_piece(air, h, mu, perigee, length - perigee, false, steps);
    if (perigee > 0.0 * m) {
        AirColumns falling = kaneda1991_piece(air, h, mu, 0.0 * m, perigee, true, steps);
        sum.air += falling.air;
        sum.aerosol += falling.aerosol;
    }
    return sum;
}

// What comes from the sun through the air to a point: none in the shadow of the ground.
FN Spectrum kaneda1991_sunlight(IN(ExponentialAir) air, Length h, Number mu_s, int steps) {
    if (meets_ground(h, mu_s, air.bottom)) return Spectrum(0.0);
    Length length = distance_to_top(h, mu_s, air.bottom, air.top);
    return exp(-optical_depth(air, kaneda1991_columns(air, h, mu_s, length, steps)));
}

FN void kaneda1991_march(INOUT(ScatteredLight) light, IN(ExponentialAir) air, IN(AirRay) ray, Length start, Length length, bool down,
                         int steps, int sun_steps) {
    for (int k = 0; k < steps; ++k) {
        Length t = start + crowded_middle(length, k, steps, down);
        Length h = altitude_at(ray.altitude, ray.mu, t, air.bottom);
        Number mu_s = sun_cosine_at(ray.altitude, ray.mu_s, ray.nu, t, h, air.bottom);
        add_step(light, air, air_densities(air, h), crowded_step(length, k, steps, down),
                 kaneda1991_sunlight(air, h, mu_s, sun_steps));
    }
}

FN ScatteredLight kaneda1991_light(IN(ExponentialAir) air, IN(AirRay) ray, int steps, int sun_steps) {
    ScatteredLight light = no_scattered_light();
    Length perigee = clamp(-(air.bottom + ray.altitude) * ray.mu, 0.0 * m, ray.reach);
    if (perigee > 0.0 * m) kaneda1991_march(light, air, ray, 0.0 * m, perigee, true, steps, sun_steps);
    if (perigee < ray.reach) kaneda1991_march(light, air, ray, perigee, ray.reach - perigee, false, steps, sun_steps);
    return light;
}
