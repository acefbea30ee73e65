// Hillaire's sky: light marched along the view, with all orders beyond the first from a small table. [Hillaire2020]
// What it leaves out: src/models/hillaire2020.cpp.

struct Hillaire2020 {
    Length bottom;  // radius of the ground
    Length top;     // altitude of the top of the air
    Spectrum albedo;
    int medium_size;  // texels of the tables
    int transmittance_across;
    int transmittance_down;
    int multiple_size;
};

FN Hillaire2020 hillaire2020(Length bottom, Length top, IN(Spectrum) albedo, int medium_size, int transmittance_across,
                             int transmittance_down, int multiple_size) {
    Hillaire2020 sky;
    sky.bottom = bottom;
    sky.top = top;
    sky.albedo = albedo;
    sky.medium_size = medium_size;
    sky.transmittance_across = transmittance_across;
    sky.transmittance_down = transmittance_down;
    sky.multiple_size = multiple_size;
    return sky;
}

// The air at an altitude.
struct Hillaire2020Medium {
    ScatteringSpectrum air;      // scattering of the molecules
    ScatteringSpectrum aerosol;  // and of all the rest
    ScatteringSpectrum extinction;
};
// `table`: altitudes across, evenly in their root; three rows, in the order of the members above.
FN Hillaire2020Medium hillaire2020_medium(IN(TABLE_2D(ScatteringSpectrum)) table, IN(Hillaire2020) sky, Length h) {
    Number x = texture_coordinate(altitude_coordinate(h, sky.top), sky.medium_size);
    Hillaire2020Medium medium;
    medium.air = look_up(table, TexCoord2(x, Number(1.0 / 6.0)));
    medium.aerosol = look_up(table, TexCoord2(x, Number(3.0 / 6.0)));
    medium.extinction = look_up(table, TexCoord2(x, Number(5.0 / 6.0)));
    return medium;
}

// Transmittance from a point to the sun, 0 where the ground stands before it; the table holds optical depths, by bruneton2008's map.
FN Spectrum hillaire2020_sunlight(IN(TABLE_2D(Spectrum)) transmittance, IN(Hillaire2020) sky, Length h, Number mu_s) {
    if (meets_ground(h, mu_s, sky.bottom)) return Spectrum(Number(0.0));
    Spectrum depth = look_up(transmittance, bruneton2008_transmittance_place(h, mu_s, sky.bottom, sky.top, sky.transmittance_across,
                                                                              sky.transmittance_down));
    return exp(-depth);
}

// Where a ray ends: at the ground or where the air does.
FN Length hillaire2020_end(IN(Hillaire2020) sky, Length h, Number mu) {
    return meets_ground(h, mu, sky.bottom) ? distance_to_ground(h, mu, sky.bottom) : distance_to_top(h, mu, sky.bottom, sky.top);
}

// One of the steps into which a ray is cut, and the middle of it. The ends of steps are even in the root of the distance.
struct Hillaire2020Step {
    Length span;
    Length h;
    Number mu_s;
};
FN Hillaire2020Step hillaire2020_step(IN(Hillaire2020) sky, Length h, Number mu, Number mu_s, Number nu, Length distance, int i,
                                      int steps) {
    Number from = Number(i) / Number(steps);
    Number to = Number(i + 1) / Number(steps);
    Hillaire2020Step piece;
    piece.span = distance * (to * to - from * from);
    Length t = distance * (0.5 * (from * from + to * to));
    piece.h = clamp(altitude_at(h, mu, t, sky.bottom), 0.0 * m, sky.top);
    piece.mu_s = sun_cosine_at(h, mu_s, nu, t, piece.h, sky.bottom);
    return piece;
}

// The share of light that a step of some optical depth takes: 1 - e^-depth, without the difference, which would lose all digits
// where the air is thin. With q an eighth of the depth it is (1 + e^-4q) (1 + e^-2q) (1 + e^-q) (1 - e^-q), the last by its series,
// to 2e-3 at its worst; depths above 8 take what 8 does, all but 3e-4.
FN Spectrum hillaire2020_taken(IN(Spectrum) depth) {
    Spectrum one = Spectrum(Number(1.0));
    Spectrum q = -max(-0.125 * depth, -one);
    Spectrum e = exp(-q);
    Spectrum e2 = e * e;
    Spectrum first = one - q * 0.2;
    first = one - q * first * 0.25;
    first = one - q * first * (1.0 / 3.0);
    first = q * (one - q * first * 0.5);
    return (one + e2 * e2) * (one + e2) * (one + e) * first;
}

// Light scattered twice and more, as if it came from everywhere alike. [Hillaire2020, section 5.5]
struct Hillaire2020Orders {
    PhaseSpectrum second;  // scattered twice, per scattering coefficient and irradiance of the sun
    Spectrum fraction;     // of light that is scattered once more, f_ms: each order is this times the one before
};

const int hillaire2020_directions = 8;  // squared: of the sphere
const int hillaire2020_multiple_steps = 20;

// All directions count alike, and phase functions are isotropic.
FN Hillaire2020Orders hillaire2020_orders(IN(Hillaire2020) sky, IN(TABLE_2D(ScatteringSpectrum)) medium, IN(TABLE_2D(Spectrum)) transmittance,
                                          Length h, Number mu_s) {
    Hillaire2020Orders sum;
    sum.second = PhaseSpectrum(0.0 * per_sr);
    sum.fraction = Spectrum(Number(0.0));
    Number share = 1.0 / (Number(hillaire2020_directions) * Number(hillaire2020_directions));
    for (int i = 0; i < hillaire2020_directions; ++i) {
        Number mu = 1.0 - (2.0 * Number(i) + 1.0) / Number(hillaire2020_directions);
        for (int j = 0; j < hillaire2020_directions; ++j) {
            Number phi = pi * ((2.0 * Number(j) + 1.0) / Number(hillaire2020_directions));
            Number sines = sqrt(max((1.0 - mu * mu) * (1.0 - mu_s * mu_s), Number(0.0)));
            Number nu = clamp(mu * mu_s + sines * cos(phi), Number(-1.0), Number(1.0));
            Length distance = hillaire2020_end(sky, h, mu);
            Spectrum seen = Spectrum(Number(1.0));
            for (int k = 0; k < hillaire2020_multiple_steps; ++k) {
                Hillaire2020Step piece = hillaire2020_step(sky, h, mu, mu_s, nu, distance, k, hillaire2020_multiple_steps);
                Hillaire2020Medium air = hillaire2020_medium(medium, sky, piece.h);
                Spectrum depth = air.extinction * piece.span;
                ScatteringSpectrum least = ScatteringSpectrum(1e-15 / m);
                Spectrum scattered = seen * ((air.air + air.aerosol) / max(air.extinction, least)) * hillaire2020_taken(depth);
                sum.second += scattered * hillaire2020_sunlight(transmittance, sky, piece.h, piece.mu_s) * (share / (4.0 * pi) * per_sr);
                sum.fraction += scattered * share;
                seen = seen * exp(-depth);
            }
            if (meets_ground(h, mu, sky.bottom)) {
                Number mu_g = sun_cosine_at(h, mu_s, nu, distance, 0.0 * m, sky.bottom);
                sum.second += seen * sky.albedo * hillaire2020_sunlight(transmittance, sky, 0.0 * m, mu_g) *
                              (share * max(mu_g, Number(0.0)) / pi * per_sr);
            }
        }
    }
    return sum;
}

// The sum of all orders from the second on: a geometric series. [Hillaire2020, eq. 9, 10]
FN PhaseSpectrum hillaire2020_series(IN(Hillaire2020Orders) orders) {
    return orders.second / max(Spectrum(Number(1.0)) - orders.fraction, Spectrum(Number(1e-3)));
}

// The place of that sum in its table: sun across, altitude down.
FN TexCoord2 hillaire2020_multiple_place(IN(Hillaire2020) sky, Length h, Number mu_s) {
    return TexCoord2(texture_coordinate(clamp(0.5 + 0.5 * mu_s, Number(0.0), Number(1.0)), sky.multiple_size),
                     texture_coordinate(clamp(h / sky.top, Number(0.0), Number(1.0)), sky.multiple_size));
}

// What reaches the eye over a distance: per irradiance of the sun.
struct Hillaire2020Light {
    PhaseSpectrum inscattered;
    Spectrum transmittance;
};
FN Hillaire2020Light hillaire2020_march(IN(Hillaire2020) sky, IN(TABLE_2D(ScatteringSpectrum)) medium, IN(TABLE_2D(Spectrum)) transmittance,
                                        IN(TABLE_2D(PhaseSpectrum)) multiple, Length h, Number mu, Number mu_s, Number nu, Length distance,
                                        int steps, IN(PhaseSpectrum) air_phase, IN(PhaseSpectrum) aerosol_phase) {
    Hillaire2020Light light;
    light.inscattered = PhaseSpectrum(0.0 * per_sr);
    light.transmittance = Spectrum(Number(1.0));
    for (int i = 0; i < steps; ++i) {
        Hillaire2020Step piece = hillaire2020_step(sky, h, mu, mu_s, nu, distance, i, steps);
        Hillaire2020Medium air = hillaire2020_medium(medium, sky, piece.h);
        Spectrum sunlight = hillaire2020_sunlight(transmittance, sky, piece.h, piece.mu_s);
        PhaseSpectrum higher = look_up(multiple, hillaire2020_multiple_place(sky, piece.h, piece.mu_s));
        PhasedScatteringSpectrum source =
            (air.air * air_phase + air.aerosol * aerosol_phase) * sunlight + (air.air + air.aerosol) * higher;
        Spectrum depth = air.extinction * piece.span;
        ScatteringSpectrum least = ScatteringSpectrum(1e-15 / m);
        light.inscattered += light.transmittance * (source / max(air.extinction, least)) * hillaire2020_taken(depth);
        light.transmittance = light.transmittance * exp(-depth);
    }
    return light;
}

// Radiance of the ground under the sun alone, per irradiance of the sun.
FN PhaseSpectrum hillaire2020_ground(IN(Hillaire2020) sky, IN(TABLE_2D(Spectrum)) transmittance, Number mu_s) {
    return sky.albedo * hillaire2020_sunlight(transmittance, sky, 0.0 * m, mu_s) * (max(mu_s, Number(0.0)) / pi * per_sr);
}

// The sky-view table: azimuth from the sun across, from the zenith (0) over the horizon to the nadir (1) down. Rows crowd towards
// the horizon as the square, on both sides, and no row stands for both. [Hillaire2020, section 5.3]
FN Number hillaire2020_sky_view_row(Length h, Number mu, Length bottom, int rows) {
    Number zenith = angle_of_cosine(mu);
    Number horizon = angle_of_cosine(horizon_cosine(h, bottom));
    int half_rows = rows / 2;
    if (meets_ground(h, mu, bottom)) {
        Number x = sqrt(clamp((zenith - horizon) / (pi - horizon), Number(0.0), Number(1.0)));
        return 0.5 + 0.5 * texture_coordinate(x, half_rows);
    }
    Number x = 1.0 - sqrt(clamp(1.0 - zenith / horizon, Number(0.0), Number(1.0)));
    return 0.5 * texture_coordinate(x, half_rows);
}
// Zenith angle of row `row`, whose rays meet the ground from the middle row on.
FN Number hillaire2020_zenith_of_row(Length h, int row, Length bottom, int rows) {
    Number horizon = angle_of_cosine(horizon_cosine(h, bottom));
    int half_rows = rows / 2;
    if (row >= half_rows) {
        Number x = Number(row - half_rows) / (Number(half_rows) - 1.0);
        return horizon + x * x * (pi - horizon);
    }
    Number x = 1.0 - Number(row) / (Number(half_rows) - 1.0);
    return horizon * (1.0 - x * x);
}
FN TexCoord2 hillaire2020_sky_view_place(Length h, Number mu, Number cos_azimuth, Length bottom, int columns, int rows) {
    return TexCoord2(texture_coordinate(azimuth_coordinate(cos_azimuth), columns), hillaire2020_sky_view_row(h, mu, bottom, rows));
}

// The aerial-perspective volume: distance in even slices, of which the first stands one slice from the eye; nearer than that the
// light grows in proportion. [Hillaire2020, section 5.4]
struct Hillaire2020Slices {
    Number coordinate;  // in depth
    Number weight;      // of what is there
};
FN Hillaire2020Slices hillaire2020_slices(Length distance, Length range, int slices) {
    Number x = distance / range * Number(slices);
    Hillaire2020Slices place;
    place.weight = clamp(x, Number(0.0), Number(1.0));
    place.coordinate = (x - 0.5) / Number(slices);
    return place;
}
FN Length hillaire2020_slice_distance(int slice, Length range, int slices) {
    return range * (Number(slice + 1) / Number(slices));
}
