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
