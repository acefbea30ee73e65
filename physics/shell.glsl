// Rays in a spherical shell of air. Theory: docs/theory.md, section 1.
// Altitudes, not radii, are the arguments, and differences of squares are factored: float then stays within
// 3e-7 of double, where the textbook forms with radii lose up to 19 m.

// Distance from a point to the top of the atmosphere, along a ray that does not meet the ground.
//   h       altitude of the point above the ground, 0 <= h <= top
//   mu      cosine of the ray's zenith angle at the point, -1 <= mu <= 1
//   bottom  radius of the ground
//   top     altitude of the top of the atmosphere
// Returns a length >= 0. Theory: eq. 1.
FN Length distance_to_top(Length h, Number mu, Length bottom, Length top) {
    Area k = (top - h) * (2.0 * bottom + top + h);
    Length p = (bottom + h) * mu;
    Length s = sqrt(k + p * p);
    return mu > 0.0 ? k / (p + s) : s - p;
}

// Whether a ray meets the ground: it goes down, and more steeply than to the horizon. Theory: eq. 2.
// Not by the perigee's radius, r^2 (1 - mu^2) < bottom^2: 2 m up, the horizon's mu^2 is 6e-7, and float rounds 1 - mu^2 by 6e-8.
FN bool meets_ground(Length h, Number mu, Length bottom) {
    Length p = (bottom + h) * mu;
    return mu < 0.0 && p * p > h * (2.0 * bottom + h);
}

// Cosine of the zenith angle of the horizon seen from altitude h: -1 <= mu <= 0. Theory: eq. 3.
FN Number horizon_cosine(Length h, Length bottom) {
    return -sqrt(h * (2.0 * bottom + h)) / (bottom + h);
}

// Distance to the ground along a ray that meets it. Theory: eq. 4.
FN Length distance_to_ground(Length h, Number mu, Length bottom) {
    Area k = h * (2.0 * bottom + h);
    Length p = (bottom + h) * mu;
    Length s = sqrt(max(p * p - k, 0.0 * m * m));
    return k / (s - p);
}

// Altitude of the point at distance t along a ray. Theory: eq. 5.
// r_t as the root of a sum of squares: r * r + gain cancels on the way past a small planet from far away,
// where float then loses kilometres.
FN Length altitude_at(Length h, Number mu, Length t, Length bottom) {
    Length r = bottom + h;
    Length along = r * mu + t;
    Length r_t = sqrt(max(along * along + r * r * ((1.0 - mu) * (1.0 + mu)), 0.0 * m * m));
    return h + t * (r * mu + along) / (r_t + r);
}

// Cosine of the zenith angle, at the point at distance t, of the ray itself: -1 <= mu_t <= 1. Theory: eq. 6.
FN Number cosine_at(Length h, Number mu, Length t, Length h_t, Length bottom) {
    return clamp(((bottom + h) * mu + t) / (bottom + h_t), Number(-1.0), Number(1.0));
}

// Cosine of the sun's zenith angle at the point at distance t; nu is the cosine between view and sun. Theory: eq. 7.
FN Number sun_cosine_at(Length h, Number mu_s, Number nu, Length t, Length h_t, Length bottom) {
    return clamp(((bottom + h) * mu_s + t * nu) / (bottom + h_t), Number(-1.0), Number(1.0));
}

// The part of a uniform disk that stands above a straight horizon; x is the height of its centre in units of its radius.
FN Number disk_above(Number x) {
    Number c = clamp(x, Number(-1.0), Number(1.0));
    return 0.5 + (c * sqrt(1.0 - c * c) + asin(c)) / pi;
}

// The part of the sun's disk, of an angular radius, that stands above the horizon of altitude h.
FN Number sun_above_horizon(Length h, Number mu_s, Length bottom, Number sun_radius) {
    Number horizon = horizon_cosine(h, bottom);
    Number sine = sqrt(max(1.0 - horizon * horizon, Number(1e-6)));
    Number above = (mu_s - horizon) / sine;  // the height of the sun's centre above the horizon, in radians
    return sun_radius > 0.0 ? disk_above(above / sun_radius) : (above >= 0.0 ? Number(1.0) : Number(0.0));
}
