// Bruneton and Neyret's tables: their maps, and what is read from them. [BrunetonNeyret2008, section 4; Bruneton2017]
// What they hold and leave out: src/models/bruneton2008.cpp.

// The shape of the tables. The scattering tables have four dimensions (altitude, view zenith, sun zenith, angle between view and
// sun), of which a texture holds the last two side by side, the sun's fastest; between texels of the last one the text itself mixes.
struct Bruneton2008 {
    Length bottom;  // radius of the ground
    Length top;     // altitude of the top of the air
    int altitude_size;
    int view_size;  // even: half of the texels for rays to the ground, half for the rest
    int sun_size;
    int nu_size;
    bool twilight;  // whether the sun's axis is transport's, finer in twilight and on to 120 degrees, and not the paper's
};

FN Bruneton2008 bruneton2008(Length bottom, Length top, int altitude_size, int view_size, int sun_size, int nu_size) {
    Bruneton2008 shape;
    shape.bottom = bottom;
    shape.top = top;
    shape.altitude_size = altitude_size;
    shape.view_size = view_size;
    shape.sun_size = sun_size;
    shape.nu_size = nu_size;
    shape.twilight = false;
    return shape;
}

// Altitude: by the distance to the horizon, rho.
FN Number bruneton2008_altitude_coordinate(Length h, Length bottom, Length top) {
    return sqrt(clamp(h * (2.0 * bottom + h) / (top * (2.0 * bottom + top)), Number(0.0), Number(1.0)));
}
FN Length bruneton2008_altitude_of_coordinate(Number x, Length bottom, Length top) {
    Area k = x * x * (top * (2.0 * bottom + top));
    return k / (sqrt(bottom * bottom + k) + bottom);
}

// Direction of a ray to the top of the air: linear in its length, from the shortest to the longest.
// d - nearest as a product of positive factors: near the zenith the difference cancels.
FN Number bruneton2008_sky_coordinate(Length h, Number mu, Length bottom, Length top) {
    Length r = bottom + h;
    Length r_top = bottom + top;
    Length d = distance_to_top(h, mu, bottom, top);
    Length at_top = sqrt((top - h) * (r_top + r) + r * mu * (r * mu));
    Length longer = d * (r * (1.0 - mu) / (r_top + r)) * (1.0 + r * (1.0 + mu) / (r_top + at_top));
    return clamp(longer / transmittance_span(h, bottom, top), Number(0.0), Number(1.0));
}
FN Number bruneton2008_sky_cosine(Length h, Number x, Length bottom, Length top) {
    Length nearest = top - h;
    Length longer = x * transmittance_span(h, bottom, top);
    Length d = nearest + longer;
    if (d <= 0.0 * m) return Number(1.0);
    Length r = bottom + h;
    return clamp(1.0 - longer / d * ((2.0 * (r + nearest) + longer) / (2.0 * r)), Number(-1.0), Number(1.0));
}

// Direction of a ray to the ground: linear in its length, from straight down (0) to the horizon (1).
FN Number bruneton2008_ground_coordinate(Length h, Number mu, Length bottom) {
    Length d = distance_to_ground(h, mu, bottom);
    Length longest = sqrt(h * (2.0 * bottom + h));
    return longest > h ? clamp((d - h) / (longest - h), Number(0.0), Number(1.0)) : Number(0.0);
}
FN Number bruneton2008_ground_cosine(Length h, Number x, Length bottom) {
    Length longest = sqrt(h * (2.0 * bottom + h));
    Length d = h + x * (longest - h);
    if (d <= 0.0 * m) return Number(-1.0);
    Length r = bottom + h;
    return clamp(-(h * (2.0 * bottom + h) + d * d) / (2.0 * r * d), Number(-1.0), Number(1.0));
}

// Light on the way to the ground is nothing at the ground, and grows with the way until it is deep: over this it is smooth there, where
// a table has few altitudes. `d` is the way.
const Length bruneton2008_knee = 3e4 * m;
FN Number bruneton2008_gain(Length d) {
    return d / (d + bruneton2008_knee);
}

// Sun: texels crowd towards the horizon and end where the sun is 11.5 degrees below it. [BrunetonNeyret2008, section 4]
FN Number bruneton2008_sun_coordinate(Number mu_s) {
    return clamp((1.0 - exp(-3.0 * max(mu_s, Number(-0.2)) - 0.6)) / (1.0 - exp(Number(-3.6))), Number(0.0), Number(1.0));
}
FN Number bruneton2008_sun_of_coordinate(Number x) {
    return clamp(-(log(1.0 - x * (1.0 - exp(Number(-3.6)))) + 0.6) / 3.0, Number(-0.2), Number(1.0));
}

// The same on the axis that a shape has.
FN Number bruneton2008_chosen_sun_coordinate(Number mu_s, bool twilight) {
    return twilight ? sun_coordinate(mu_s) : bruneton2008_sun_coordinate(mu_s);
}
FN Number bruneton2008_chosen_sun_of_coordinate(Number x, bool twilight) {
    return twilight ? sun_of_coordinate(x) : bruneton2008_sun_of_coordinate(x);
}

// Where a view finds its light in the scattering tables.
struct Bruneton2008Place {
    Number low;     // across, for the texel of nu below
    Number high;    // and above
    Number weight;  // of the one above
    Number view;
    Number altitude;
};

// `ground`: whether the ray meets the ground. It is asked once for a view, at its start, so that both look-ups of an aerial
// perspective are on one side of the horizon.
FN Bruneton2008Place bruneton2008_place(IN(Bruneton2008) shape, Length h, Number mu, Number mu_s, Number nu, bool ground) {
    Bruneton2008Place place;
    Number sun = texture_coordinate(bruneton2008_chosen_sun_coordinate(mu_s, shape.twilight), shape.sun_size);
    Number x = clamp(0.5 + 0.5 * nu, Number(0.0), Number(1.0)) * (Number(shape.nu_size) - 1.0);
    Number texel = min(floor(x), Number(shape.nu_size) - 2.0);
    place.weight = x - texel;
    place.low = (texel + sun) / Number(shape.nu_size);
    place.high = (texel + 1.0 + sun) / Number(shape.nu_size);
    int half_size = shape.view_size / 2;
    if (ground) {
        place.view = 0.5 * texture_coordinate(bruneton2008_ground_coordinate(h, mu, shape.bottom), half_size);
    } else {
        place.view = 0.5 + 0.5 * texture_coordinate(bruneton2008_sky_coordinate(h, mu, shape.bottom, shape.top), half_size);
    }
    place.altitude = texture_coordinate(bruneton2008_altitude_coordinate(h, shape.bottom, shape.top), shape.altitude_size);
    return place;
}

// Light scattered twice and more; and light scattered once, by one kind of particle, which times its phase function is radiance.
FN RadianceSpectrum bruneton2008_multiple(IN(TABLE_3D(RadianceSpectrum)) table, IN(Bruneton2008Place) at) {
    RadianceSpectrum low = look_up(table, TexCoord3(at.low, at.view, at.altitude));
    RadianceSpectrum high = look_up(table, TexCoord3(at.high, at.view, at.altitude));
    return low + (high - low) * at.weight;
}
FN IrradianceSpectrum bruneton2008_single(IN(TABLE_3D(IrradianceSpectrum)) table, IN(Bruneton2008Place) at) {
    IrradianceSpectrum low = look_up(table, TexCoord3(at.low, at.view, at.altitude));
    IrradianceSpectrum high = look_up(table, TexCoord3(at.high, at.view, at.altitude));
    return low + (high - low) * at.weight;
}

// Single Mie scattering by the rule of proportion: a table of four channels holds it at one wavelength, `mie`, and its colour is
// taken to be that of `rayleigh` (single Rayleigh scattering and all higher orders, over Rayleigh's phase function), corrected
// by the ratio of the coefficients. [BrunetonNeyret2008, section 4, eq. 18]
//   mie_over_rayleigh  `mie` over `rayleigh` at the wavelength of `mie`
//   ratio              Mie over Rayleigh coefficient at each wavelength, over the same at that wavelength
FN IrradianceSpectrum bruneton2008_proportional_mie(IN(IrradianceSpectrum) rayleigh, Number mie_over_rayleigh, IN(Spectrum) ratio) {
    return rayleigh * ratio * mie_over_rayleigh;
}

// Transmittance from a point to the top of the air, along a ray that does not meet the ground: altitude down, direction across.
FN TexCoord2 bruneton2008_transmittance_place(Length h, Number mu, Length bottom, Length top, int across, int down) {
    return TexCoord2(texture_coordinate(bruneton2008_sky_coordinate(h, mu, bottom, top), across),
                     texture_coordinate(bruneton2008_altitude_coordinate(h, bottom, top), down));
}

// Transmittance of the first `d` of a ray: the quotient of two look-ups, of the ray or, if it meets the ground, of its reverse.
// The table holds optical depths: where transmittances vanish, their quotient would be lost.
FN Spectrum bruneton2008_transmittance(IN(TABLE_2D(Spectrum)) table, IN(Bruneton2008) shape, int across, int down, Length h, Number mu,
                                       Length d, bool ground) {
    Length h_d = clamp(altitude_at(h, mu, d, shape.bottom), 0.0 * m, shape.top);
    Number mu_d = cosine_at(h, mu, d, h_d, shape.bottom);
    Spectrum near_depth;
    Spectrum far_depth;
    if (ground) {
        near_depth = look_up(table, bruneton2008_transmittance_place(h_d, -mu_d, shape.bottom, shape.top, across, down));
        far_depth = look_up(table, bruneton2008_transmittance_place(h, -mu, shape.bottom, shape.top, across, down));
    } else {
        near_depth = look_up(table, bruneton2008_transmittance_place(h, mu, shape.bottom, shape.top, across, down));
        far_depth = look_up(table, bruneton2008_transmittance_place(h_d, mu_d, shape.bottom, shape.top, across, down));
    }
    return exp(-max(near_depth - far_depth, Spectrum(Number(0.0))));
}

// Irradiance by the sky of a level surface that faces up: altitude down, sun across, both evenly.
FN TexCoord2 bruneton2008_irradiance_place(Length h, Number mu_s, Length top, int across, int down) {
    return TexCoord2(texture_coordinate(clamp((mu_s + 0.2) / 1.2, Number(0.0), Number(1.0)), across),
                     texture_coordinate(clamp(h / top, Number(0.0), Number(1.0)), down));
}

// Radiance of the ground where a ray ends, under the sun and under the sky.
//   mu_s          cosine of the sun's zenith angle there
//   sun_disk      irradiance by the sun through air of no depth, of a surface facing it
FN RadianceSpectrum bruneton2008_ground(IN(TABLE_2D(Spectrum)) transmittance, IN(TABLE_2D(IrradianceSpectrum)) irradiance,
                                        IN(Bruneton2008) shape, int across, int down, int irradiance_across, int irradiance_down,
                                        Number mu_s, IN(IrradianceSpectrum) sun_disk, IN(Spectrum) albedo) {
    Number facing = max(mu_s, Number(0.0));
    Spectrum depth = look_up(transmittance, bruneton2008_transmittance_place(0.0 * m, facing, shape.bottom, shape.top, across, down));
    IrradianceSpectrum light = look_up(irradiance, bruneton2008_irradiance_place(0.0 * m, mu_s, shape.top, irradiance_across, irradiance_down));
    light += sun_disk * exp(-depth) * facing;
    return light * albedo * (1.0 / pi * per_sr);
}
