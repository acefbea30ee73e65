// Perez's formula for the relative luminance of the sky, which several models share.
// [Perez1993], [Preetham1999]

// a, b: gradation from zenith to horizon; c, d, e: the sun's aureole and the backscatter.
struct PerezCoefficients {
    Number a;
    Number b;
    Number c;
    Number d;
    Number e;
};

// Relative luminance towards a zenith angle of cosine mu >= 0 and an angle gamma from the sun, of cosine nu. b < 0, so that
// the horizon, where the formula divides by zero, is its limit. [Perez1993, eq. 1]
FN Number perez(IN(PerezCoefficients) k, Number mu, Number nu, Number gamma) {
    Number gradation = 1.0 + k.a * exp(k.b / max(mu, Number(1e-3)));
    return gradation * (1.0 + k.c * exp(k.d * gamma) + k.e * nu * nu);
}
