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

// The angle whose cosine is x, -1 <= x <= 1, to 2e-8. [AbramowitzStegun1964, eq. 4.4.46]
// The acos of GLSL may be off by 1e-4; this one has a root and a polynomial alone, so that every reading has the same.
FN Number angle_of_cosine(Number x) {
    Number a = abs(x);
    Number p = 0.0066700901 - 0.0012624911 * a;
    p = p * a - 0.0170881256;
    p = p * a + 0.0308918810;
    p = p * a - 0.0501743046;
    p = p * a + 0.0889789874;
    p = p * a - 0.2145988016;
    p = p * a + 1.5707963050;
    Number acute = sqrt(max(1.0 - a, Number(0.0))) * p;
    return 0.5 * pi - sign(x) * (0.5 * pi - acute);
}

// Relative luminance towards a zenith angle of cosine mu >= 0 and an angle gamma from the sun, of cosine nu. b < 0, so that
// the horizon, where the formula divides by zero, is its limit. [Perez1993, eq. 1]
FN Number perez(IN(PerezCoefficients) k, Number mu, Number nu, Number gamma) {
    Number gradation = 1.0 + k.a * exp(k.b / max(mu, Number(1e-3)));
    return gradation * (1.0 + k.c * exp(k.d * gamma) + k.e * nu * nu);
}
