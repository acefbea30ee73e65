// The colour of the sea: what its surface mirrors, and what its water sends back. [NishitaEtAl1993, sec. 4.2; Gordon1973]

const Number sea_refractive_index = 1.34;

// Fresnel's reflectance of unpolarised light at a smooth surface; c is the cosine of the angle of incidence in the air.
FN Number sea_reflectance(Number c) {
    Number n = sea_refractive_index;
    Number t = sqrt(1.0 - (1.0 - c * c) / (n * n));
    Number s = (c - n * t) / (c + n * t);
    Number p = (n * c - t) / (n * c + t);
    return 0.5 * (s * s + p * p);
}

// Cosine of the refracted angle in the water.
FN Number sea_refracted(Number c) {
    Number n = sea_refractive_index;
    return sqrt(1.0 - (1.0 - c * c) / (n * n));
}

// Radiance above the surface of deep water from light of its molecules, over the irradiance of a beam on a plane facing it:
// scattered once, light scattered forward counting as not scattered (quasi-single scattering). Absorption and scattering of
// the water in 1/m; cosines of the zenith angles of sun and view in the air, both > 0. [Gordon1973, eq. 12]
FN PhaseSpectrum sea_water_radiance(IN(ScatteringSpectrum) absorption, IN(ScatteringSpectrum) scattering, Number mu_s, Number mu,
                                    Number nu) {
    Number n = sea_refractive_index;
    Number sun_below = sea_refracted(mu_s);
    Number view_below = sea_refracted(mu);
    Number through = (1.0 - sea_reflectance(mu_s)) * (1.0 - sea_reflectance(mu)) / (n * n);
    // The scattering angle below the surface: horizontal components shrink by n, and sunlight runs down.
    Number nu_below = clamp(-(nu - mu_s * mu) / (n * n) - sun_below * view_below, Number(-1.0), Number(1.0));
    Number geometry = through * mu_s / (sun_below + view_below);
    return scattering / (absorption + 0.5 * scattering) * (rayleigh_phase(nu_below) * geometry);
}
