// Dobashi's sky: planes before the eye, blended from the farthest to the nearest; sub-planes between them where light changes
// fast; sunlight from a texture. What it is and leaves out: src/models/dobashi2002.cpp. [Dobashi2002]

// Texture: optical depth to the sun, by the sun's zenith angle along x and by altitude along y.
FN Spectrum dobashi2002_sunlight(IN(ExponentialAir) air, IN(TABLE_2D(Spectrum)) table, int cosines, int altitudes, Length h,
                                 Number mu_s) {
    if (meets_ground(h, mu_s, air.bottom)) return Spectrum(0.0);
    Number x = texture_coordinate(transmittance_cosine_coordinate(h, mu_s, air.bottom, air.top), cosines);
    Number y = texture_coordinate(altitude_coordinate(h, air.top), altitudes);
    return exp(-look_up(table, TexCoord2(x, y)));
}

// What the blending unit does: the light of a nearer slab over that of all behind it.
FN void dobashi2002_blend(INOUT(ScatteredLight) behind, IN(ScatteredLight) slab) {
    Spectrum through = exp(-slab.depth);
    behind.air = slab.air + through * behind.air;
    behind.aerosol = slab.aerosol + through * behind.aerosol;
    behind.depth += slab.depth;
}

// Distance of a plane, x from 0 (the eye) to 1 (the end): they crowd towards the lowest point of the ray, if it is an end.
FN Length dobashi2002_plane(Length length, Length perigee, Number x) {
    if (perigee <= 0.25 * length) return length * (x * x);
    return perigee >= 0.75 * length ? length * (x * (2.0 - x)) : length * x;
}

// The light between two planes: `subplanes` samples.
FN ScatteredLight dobashi2002_slab(IN(ExponentialAir) air, IN(TABLE_2D(Spectrum)) table, int cosines, int altitudes, IN(AirRay) ray,
                                   Length first, Length last, int subplanes) {
    ScatteredLight slab = no_scattered_light();
    Length step = (last - first) / Number(subplanes);
    for (int k = 0; k < subplanes; ++k) {
        Length t = first + (Number(k) + 0.5) * step;
        Length h = altitude_at(ray.altitude, ray.mu, t, air.bottom);
        Number mu_s = sun_cosine_at(ray.altitude, ray.mu_s, ray.nu, t, h, air.bottom);
        add_step(slab, air, air_densities(air, h), step, dobashi2002_sunlight(air, table, cosines, altitudes, h, mu_s));
    }
    return slab;
}

FN ScatteredLight dobashi2002_light(IN(ExponentialAir) air, IN(TABLE_2D(Spectrum)) table, int cosines, int altitudes, IN(AirRay) ray,
                                    int planes, int subplanes) {
    ScatteredLight light = no_scattered_light();
    Length perigee = -(air.bottom + ray.altitude) * ray.mu;
    for (int k = planes - 1; k >= 0; --k) {
        Length first = dobashi2002_plane(ray.reach, perigee, Number(k) / Number(planes));
        Length last = dobashi2002_plane(ray.reach, perigee, (Number(k) + 1.0) / Number(planes));
        dobashi2002_blend(light, dobashi2002_slab(air, table, cosines, altitudes, ray, first, last, subplanes));
    }
    return light;
}
