// The CIE's standard general skies: Perez's gradation, and an indicatrix that is free of the sun's side at right angles to it.
// What they are and leave out: src/models/cie2003.cpp. [CIE2003, eq. 2 to 4]

// Relative luminance towards a zenith angle of cosine mu >= 0, at an angle gamma from the sun, of cosine nu.
FN Number cie2003(IN(PerezCoefficients) k, Number mu, Number nu, Number gamma) {
    Number gradation = 1.0 + k.a * exp(k.b / max(mu, Number(1e-3)));
    return gradation * (1.0 + k.c * (exp(k.d * gamma) - exp(k.d * (0.5 * pi))) + k.e * nu * nu);
}
