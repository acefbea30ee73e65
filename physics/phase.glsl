// Phase functions, by the cosine nu of the scattering angle (1: forward); each integrates to one over the sphere.
// Theory: docs/theory.md, section 3.1.

// Rayleigh's, for particles without depolarisation. [Chandrasekhar1960, ch. 1, eq. 26]
FN InverseSolidAngle rayleigh_phase(Number nu) {
    return 3.0 / (16.0 * pi) * (1.0 + nu * nu) * per_sr;
}

// Rayleigh's with anisotropic molecules; gamma = depolarisation / (2 - depolarisation). [Chandrasekhar1960, ch. 1, eq. 29; Bucholtz1995, eq. 12]
FN InverseSolidAngle depolarised_rayleigh_phase(Number gamma, Number nu) {
    return 3.0 / (16.0 * pi * (1.0 + 2.0 * gamma)) * ((1.0 + 3.0 * gamma) + (1.0 - gamma) * nu * nu) * per_sr;
}

// 1 + g^2 - 2 g nu, the square of the third side of a triangle with the sides 1 and g, as a sum of positive terms:
// the short form cancels in the peak, where float is then up to 10 % off at g = 0.999 (this form: 2e-7).
FN Number peak_distance_squared(Number g, Number nu) {
    Number a = abs(g);
    Number off_peak = g < 0.0 ? 1.0 + nu : 1.0 - nu;
    return (1.0 - a) * (1.0 - a) + 2.0 * a * off_peak;
}

// Henyey and Greenstein's; g is the mean cosine, -1 < g < 1. [HenyeyGreenstein1941, eq. 2]
FN InverseSolidAngle henyey_greenstein_phase(Number g, Number nu) {
    Number k = peak_distance_squared(g, nu);
    return (1.0 - g) * (1.0 + g) / (4.0 * pi * k * sqrt(k)) * per_sr;
}

// Cornette and Shanks': Rayleigh's as g -> 0. Its mean cosine is not g. [CornetteShanks1992, eq. 8]
FN InverseSolidAngle cornette_shanks_phase(Number g, Number nu) {
    Number k = peak_distance_squared(g, nu);
    return 3.0 * (1.0 - g) * (1.0 + g) * (1.0 + nu * nu) / (8.0 * pi * (2.0 + g * g) * k * sqrt(k)) * per_sr;
}

// Schlick's rational stand-in for Henyey and Greenstein's, without a root; -1 < k < 1. [BlasiLeSaecSchlick1993, eq. 4]
FN InverseSolidAngle schlick_phase(Number k, Number nu) {
    Number q = 1.0 - k * nu;
    return (1.0 - k * k) / (4.0 * pi * q * q) * per_sr;
}

// The k with which Schlick's comes closest to Henyey and Greenstein's of mean cosine g. [PharrHumphreys2004, ch. 11]
FN Number schlick_parameter(Number g) {
    return 1.55 * g - 0.55 * g * g * g;
}

// Rayleigh's with half the contrast, which Nielsen chose by eye for displays without a tone curve. [Nielsen2003, eq. 5.2]
// His factor 3 / (16 pi) integrates to 13/8 over the sphere; this one to one.
FN InverseSolidAngle softened_rayleigh_phase(Number nu) {
    return 3.0 / (26.0 * pi) * (2.0 + 0.5 * nu * nu) * per_sr;
}
