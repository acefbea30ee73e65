// Maps between physical arguments and table coordinates in [0, 1]. Theory: docs/theory.md, section 5.1.
// Each pair is a map and its inverse; the tests go there and back at every table size.

// The coordinate of a texture with `size` texels whose first and last texel centres stand for x = 0 and x = 1.
FN Number texture_coordinate(Number x, int size) {
    return 0.5 / Number(size) + x * (1.0 - 1.0 / Number(size));
}

// Altitude: texels crowd towards the ground as the square. Theory: eq. 20.
FN Number altitude_coordinate(Length h, Length top) {
    return sqrt(clamp(h / top, Number(0.0), Number(1.0)));
}
FN Length altitude_of_coordinate(Number x, Length top) {
    return x * x * top;
}

// Direction of a ray that does not meet the ground, by its distance d to the top of the atmosphere: nearly even in d where
// d is small, in 1/d where it is large, so that neither a steep ray nor a grazing one is short of texels. Theory: eq. 21.
// Only sums of positive terms: on a planet that is small beside its air, d - nearest and farthest - nearest cancel, and
// float then lost 1.4e-4 of the coordinate.
FN Length transmittance_span(Length h, Length bottom, Length top) {
    Length to_the_horizon = sqrt(h * (2.0 * bottom + h));
    Length beyond = sqrt(top * (2.0 * bottom + top));
    return to_the_horizon + h + 2.0 * bottom * (top / (beyond + top));
}
FN Number transmittance_cosine_coordinate(Length h, Number mu, Length bottom, Length top) {
    Length d = distance_to_top(h, mu, bottom, top);
    Length r = bottom + h;
    Length r_top = bottom + top;
    Length at_top = sqrt((top - h) * (r_top + r) + r * mu * (r * mu));
    Number detour = r * (1.0 - mu) * (1.0 + r * (1.0 + mu) / (r_top + at_top)) / (r_top + r);
    Length span = transmittance_span(h, bottom, top);
    Length knee = 3.0 * top;
    return clamp(d * detour / (d + knee) * ((top - h + knee + span) / span), Number(0.0), Number(1.0));
}
FN Number transmittance_cosine_of_coordinate(Length h, Number x, Length bottom, Length top) {
    Length nearest = top - h;
    Length knee = 3.0 * top;
    Length span = transmittance_span(h, bottom, top);
    Number q = x * (span / (nearest + knee + span));
    Length longer = q * (nearest + knee) / (1.0 - q);
    Length d = nearest + longer;
    if (d <= 0.0 * m) return Number(1.0);
    Length r = bottom + h;
    return clamp(1.0 - longer / d * ((2.0 * (r + nearest) + longer) / (2.0 * r)), Number(-1.0), Number(1.0));
}

// Sun: texels crowd around a zenith angle of 95 degrees, where twilight fades by a factor in each degree;
// the coordinate runs from 120 degrees (0; night, for air not deeper than 0.15 of the planet's radius) to the zenith (1).
// Theory: eq. 22.
const Number twilight_cosine = -0.087;
const Number twilight_width = 0.08;
const Number lowest_sun_cosine = -0.5;
FN Number sun_coordinate(Number mu_s) {
    Number low = asinh((lowest_sun_cosine - twilight_cosine) / twilight_width);
    Number high = asinh((1.0 - twilight_cosine) / twilight_width);
    return clamp((asinh((mu_s - twilight_cosine) / twilight_width) - low) / (high - low), Number(0.0), Number(1.0));
}
FN Number sun_of_coordinate(Number x) {
    Number low = asinh((lowest_sun_cosine - twilight_cosine) / twilight_width);
    Number high = asinh((1.0 - twilight_cosine) / twilight_width);
    return clamp(twilight_cosine + twilight_width * sinh(low + x * (high - low)), Number(-1.0), Number(1.0));
}

// View zenith angle: even in the angle. Theory: eq. 23.
FN Number view_coordinate(Number mu) {
    return acos(clamp(mu, Number(-1.0), Number(1.0))) / pi;
}
FN Number view_of_coordinate(Number x) {
    return cos(x * pi);
}

// Relative azimuth phi, by its cosine: even in sin(phi / 2), which is nearly even in the angle near the sun. Theory: eq. 24.
FN Number azimuth_coordinate(Number cos_phi) {
    return sqrt(clamp(0.5 * (1.0 - cos_phi), Number(0.0), Number(1.0)));
}
FN Number azimuth_cosine_of_coordinate(Number x) {
    return 1.0 - 2.0 * x * x;
}

// The cosine of the relative azimuth of view and sun, from the cosines of their zenith angles and of the angle between them.
// Where one of them stands in the zenith the azimuth has no meaning, and 1 is returned. Theory: eq. 25.
FN Number relative_azimuth_cosine(Number mu, Number mu_s, Number nu) {
    Number sines = sqrt(max((1.0 - mu * mu) * (1.0 - mu_s * mu_s), Number(0.0)));
    return sines > 1e-6 ? clamp((nu - mu * mu_s) / sines, Number(-1.0), Number(1.0)) : Number(1.0);
}
