// Hosek and Wilkie's sky at one wavelength: Perez's formula with terms for the aureole and the zenith.
// What it is and leaves out: src/models/hosek2012.cpp. [HosekWilkie2012, eq. 6 to 11; HosekWilkie2013]

// The nine parameters and the mean radiance that they shape, for one sun.
struct Hosek2012 {
    Number a;
    Number b;
    Number c;
    Number d;
    Number e;
    Number f;
    Number g;
    Number h;
    Number i;
    Number radiance;
};

// Where the sun is on the curves of the parameters, 0 on the horizon to 1 in the zenith: they change most at sunset.
FN Number hosek2012_place(Number sun_zenith) {
    return pow(max(1.0 - sun_zenith / (0.5 * pi), Number(0.0)), 1.0 / 3.0);
}

// The Bezier curve of the fifth degree through p0 at s = 0 and p5 at s = 1.
FN Number quintic_bezier(Number p0, Number p1, Number p2, Number p3, Number p4, Number p5, Number s) {
    Number t = 1.0 - s;
    Number tt = t * t;
    Number ss = s * s;
    return tt * tt * (t * p0 + 5.0 * s * p1) + 10.0 * tt * ss * (t * p2 + s * p3) + ss * ss * (5.0 * t * p4 + s * p5);
}

// From the zenith to the horizon, mu the cosine of the zenith angle >= 0.
FN Number hosek2012_gradation(Number a, Number b, Number mu) {
    return 1.0 + a * exp(b / (mu + 0.01));
}

// Around the sun, at an angle gamma of cosine nu from it.
// The square of the distance to the peak is a sum without cancelling, and not zero where a fit has i = 1.
FN Number hosek2012_aureole(Number d, Number e, Number f, Number g, Number i, Number nu, Number gamma) {
    Number nu2 = nu * nu;
    Number q = max((1.0 - i) * (1.0 - i) + 2.0 * i * (1.0 - nu), Number(1e-6));
    return d * exp(e * gamma) + f * nu2 + g * (1.0 + nu2) / (q * sqrt(q));
}

// Radiance towards a zenith angle of cosine mu >= 0 and an angle gamma from the sun, of cosine nu.
FN Number hosek2012_radiance(IN(Hosek2012) k, Number mu, Number nu, Number gamma) {
    Number aureole = hosek2012_aureole(k.d, k.e, k.f, k.g, k.i, nu, gamma);
    return k.radiance * hosek2012_gradation(k.a, k.b, mu) * (k.c + aureole + k.h * sqrt(mu));
}
