// Eclipses of the sun by a body before it: how much of its disk's light is left. docs/theory.md, section 7.1.

// The area that two disks of radii a and b have in common, whose centres are a distance d apart. Factored as Heron's area is, and
// angles by their halves' tangents, since arc cosines lose half their digits where disks touch.
FN Number disks_in_common(Number a, Number b, Number d) {
    Number p = a + b - d;
    Number q = d + a - b;
    Number s = d - a + b;
    Number t = d + a + b;
    if (p <= 0.0) return Number(0.0);
    Number smaller = min(a, b);
    if (q <= 0.0 || s <= 0.0) return pi * smaller * smaller;
    return 2.0 * (a * a * atan(sqrt(p * s / (q * t))) + b * b * atan(sqrt(p * q / (s * t)))) - 0.5 * sqrt(p * q * s * t);
}

// Adds what the moon covers of the sun's disks between two values of mu, by a node of Gauss's rule.
FN void add_covered(Number mu, Number weight, Number moon, Number d, IN(Spectrum) dark_1, IN(Spectrum) dark_2, INOUT(Spectrum) covered) {
    Number area = disks_in_common(sqrt(1.0 - mu * mu), moon, d) * weight;
    covered = covered + (dark_1 + dark_2 * (2.0 * (1.0 - mu))) * area;
}

// The part of the sun's light that passes the moon.
//   separation    between the centres of their disks, in radians, >= 0
//   sun, moon     radii of the disks, in radians, sun > 0, moon >= 0
//   dark_1, dark_2  of limb darkening, I(mu) / I(1) = 1 - dark_1 (1 - mu) - dark_2 (1 - mu)^2; 0 is a uniform disk
// From 0 to 1: exact for a uniform disk. A darkened one is a pile of uniform disks, a rim of brightness I(0) below, the one where the sun
// is seen at mu adding dI: six of them are within 0.07 % of the sun's light of all.
FN Spectrum sunlight_left(Number separation, Number sun, Number moon, IN(Spectrum) dark_1, IN(Spectrum) dark_2) {
    if (separation >= sun + moon) return Spectrum(Number(1.0));
    if (separation + sun <= moon) return Spectrum(Number(0.0));
    Number d = separation / sun;
    Number r = moon / sun;
    Spectrum covered = (Spectrum(Number(1.0)) - dark_1 - dark_2) * disks_in_common(Number(1.0), r, d);
    add_covered(Number(0.0337652429), Number(0.0856622462), r, d, dark_1, dark_2, covered);
    add_covered(Number(0.1693953068), Number(0.1803807865), r, d, dark_1, dark_2, covered);
    add_covered(Number(0.3806904070), Number(0.2339569673), r, d, dark_1, dark_2, covered);
    add_covered(Number(0.6193095930), Number(0.2339569673), r, d, dark_1, dark_2, covered);
    add_covered(Number(0.8306046932), Number(0.1803807865), r, d, dark_1, dark_2, covered);
    add_covered(Number(0.9662347571), Number(0.0856622462), r, d, dark_1, dark_2, covered);
    Spectrum whole = pi * (Spectrum(Number(1.0)) - dark_1 * (1.0 / 3.0) - dark_2 * (1.0 / 6.0));
    return max(Spectrum(Number(1.0)) - covered / whole, Spectrum(Number(0.0)));
}
