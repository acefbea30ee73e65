// Nishita's sky and Earth: samples where the view meets spheres that lie at equal steps of density, sunlight from a table of
// optical depths summed along cylinders around the line from the planet to the sun.
// What it is and leaves out: src/models/nishita1993.cpp. [NishitaEtAl1993]

// Altitude of sphere i of n: density falls evenly from the ground (i = 0) to the top (n - 1). [NishitaEtAl1993, sec. 3.2]
FN Length nishita1993_sphere(Length top, Length scale_height, int i, int n) {
    Number x = Number(i) / Number(n - 1);
    if (i == n - 1) return top;
    return -(scale_height * log(1.0 - x * (1.0 - exp(-(top / scale_height)))));
}
// Its inverse, 0 to 1.
FN Number nishita1993_sphere_place(Length top, Length scale_height, Length h) {
    return (1.0 - exp(-(h / scale_height))) / (1.0 - exp(-(top / scale_height)));
}

// The altitude of the cylinder through a point, where it passes the planet: below the ground if it meets it.
FN Length nishita1993_cylinder(Length h, Number mu_s, Length bottom) {
    Length r = bottom + h;
    Length p = r * mu_s;
    Length radius = r * sqrt(max((1.0 - mu_s) * (1.0 + mu_s), Number(0.0)));
    return (h * (2.0 * bottom + h) - p * p) / (radius + bottom);
}

// Cylinders within the planet are even in the sun's zenith angle at the ground, those outside of it touch the spheres:
// half of the table each.
FN Number nishita1993_cylinder_place(IN(ExponentialAir) air, Length h, Number mu_s) {
    Length above = nishita1993_cylinder(h, mu_s, air.bottom);
    if (above >= 0.0 * m) return 0.5 + 0.5 * nishita1993_sphere_place(air.top, air.air_scale_height, above);
    Number sine = clamp(1.0 + above / air.bottom, Number(0.0), Number(1.0));
    return 0.5 - angle_of_cosine(sine) / pi;
}

// Optical depth towards the sun. Tables: on the side of the sun, and beyond the planet's waist, by sphere and by cylinder.
FN Spectrum nishita1993_sunlight(IN(ExponentialAir) air, IN(TABLE_2D(Spectrum)) near, IN(TABLE_2D(Spectrum)) beyond, int spheres,
                                 int cylinders, Length h, Number mu_s) {
    if (meets_ground(h, mu_s, air.bottom)) return Spectrum(0.0);
    Number x = texture_coordinate(nishita1993_sphere_place(air.top, air.air_scale_height, h), spheres);
    if (mu_s >= 0.0) {
        Number y = texture_coordinate(nishita1993_cylinder_place(air, h, mu_s), cylinders);
        return exp(-look_up(near, TexCoord2(x, y)));
    }
    Length above = max(nishita1993_cylinder(h, mu_s, air.bottom), 0.0 * m);
    Number y = texture_coordinate(nishita1993_sphere_place(air.top, air.air_scale_height, above), spheres);
    return exp(-look_up(beyond, TexCoord2(x, y)));
}

// A march in the midst: where it was last, and what was seen there.
struct Nishita1993March {
    Length distance;
    AirDensities density;
    Spectrum seen;  // sunlight that comes through to there and from there to the eye
};

// The trapezoid from the last sample to the one at distance t.
FN void nishita1993_step(INOUT(ScatteredLight) light, INOUT(Nishita1993March) last, IN(ExponentialAir) air,
                         IN(TABLE_2D(Spectrum)) near, IN(TABLE_2D(Spectrum)) beyond, int spheres, int cylinders, IN(AirRay) ray,
                         Length t) {
    Length h = altitude_at(ray.altitude, ray.mu, t, air.bottom);
    Number mu_s = sun_cosine_at(ray.altitude, ray.mu_s, ray.nu, t, h, air.bottom);
    Length step_half = 0.5 * (t - last.distance);
    AirDensities density = air_densities(air, h);
    AirColumns column;
    column.air = (density.air + last.density.air) * step_half;
    column.aerosol = (density.aerosol + last.density.aerosol) * step_half;
    light.depth += optical_depth(air, column);
    Spectrum seen = exp(-light.depth) * nishita1993_sunlight(air, near, beyond, spheres, cylinders, h, mu_s);
    light.air += (seen * density.air + last.seen * last.density.air) * step_half;
    light.aerosol += (seen * density.aerosol + last.seen * last.density.aerosol) * step_half;
    last.distance = t;
    last.density = density;
    last.seen = seen;
}

// All samples lie on spheres, but for the eye, the perigee and the end of the ray.
FN ScatteredLight nishita1993_light(IN(ExponentialAir) air, IN(TABLE_2D(Spectrum)) near, IN(TABLE_2D(Spectrum)) beyond, int spheres,
                                    int cylinders, IN(AirRay) ray) {
    ScatteredLight light = no_scattered_light();
    Nishita1993March last;
    last.distance = 0.0 * m;
    last.density = air_densities(air, ray.altitude);
    last.seen = nishita1993_sunlight(air, near, beyond, spheres, cylinders, ray.altitude, ray.mu_s);
    Length perigee = -(air.bottom + ray.altitude) * ray.mu;
    if (ray.mu < 0.0) {
        Length lowest = min(perigee, ray.reach);
        for (int i = spheres - 1; i >= 0; --i) {
            Length h = nishita1993_sphere(air.top, air.air_scale_height, i, spheres);
            if (h >= ray.altitude || !meets_ground(ray.altitude - h, ray.mu, air.bottom + h)) continue;
            Length t = distance_to_ground(ray.altitude - h, ray.mu, air.bottom + h);
            if (t > last.distance && t < lowest)
                nishita1993_step(light, last, air, near, beyond, spheres, cylinders, ray, t);
        }
        nishita1993_step(light, last, air, near, beyond, spheres, cylinders, ray, lowest);
    }
    if (perigee >= ray.reach) return light;
    for (int i = 0; i < spheres; ++i) {
        Length h = nishita1993_sphere(air.top, air.air_scale_height, i, spheres);
        Length t = 0.0 * m;
        if (h > ray.altitude) t = distance_to_top(ray.altitude, ray.mu, air.bottom, h);
        else if (ray.mu < 0.0 && meets_ground(ray.altitude - h, ray.mu, air.bottom + h))
            t = 2.0 * perigee - distance_to_ground(ray.altitude - h, ray.mu, air.bottom + h);
        if (t > last.distance && t < ray.reach)
            nishita1993_step(light, last, air, near, beyond, spheres, cylinders, ray, t);
    }
    nishita1993_step(light, last, air, near, beyond, spheres, cylinders, ray, ray.reach);
    return light;
}
