// Preetham's air: what it lets through of sunlight, and what it does to the light of things at a distance.
// What it is and leaves out: src/models/preetham1999.cpp. [Preetham1999, sec. 5]

// Transmittance of the whole air towards the sun, at an air mass and a wavelength: Angstrom's aerosol, molecules, and the
// absorption of ozone, given as its optical depth. The paper prints the air mass inside of two of the exponents of the
// wavelength, where light would not fade in a thicker layer: here it multiplies them. [Preetham1999, app. A.1]
FN Number preetham1999_sunlight(Number air_mass, Number wavelength_um, Number turbidity, Number ozone_depth) {
    Number aerosol = (0.04608 * turbidity - 0.04586) * pow(wavelength_um, -1.3);
    Number molecules = 0.008735 * pow(wavelength_um, -4.08);
    return exp(-1.0 * air_mass * (aerosol + molecules + ozone_depth));
}

// How much of an even layer's optical depth a layer has whose density falls by exp(-rise) along the way.
// A level way is a branch of its own, for the quotient is nothing over nothing there. [Preetham1999, eq. 4 and 5]
FN Number layer_share(Number rise) {
    return abs(rise) < 0.05 ? 1.0 - rise * (0.5 - rise * (1.0 / 6.0 - rise / 24.0)) : (1.0 - exp(-1.0 * rise)) / rise;
}

// The integral of v^n exp(-k v) over v from 0 to 1, n = 0 to 3, k >= 0: by its series, and where that is long by parts,
// which for small k cancels.
FN Number exponential_moment(int n, Number k) {
    Number sum = 0.0;
    if (k < 3.0) {
        Number term = 1.0;
        for (int i = 0; i < 18; ++i) {
            sum += term / Number(n + i + 1);
            term = -1.0 * term * k / Number(i + 1);
        }
        return sum;
    }
    Number e = exp(-1.0 * k);
    sum = (1.0 - e) / k;
    for (int i = 1; i <= n; ++i) sum = (Number(i) * sum - e) / k;
    return sum;
}

// Light that a layer scatters towards the eye along a way through it and a second one, over what it scatters along the same way
// through even air of the eye's density without any fading.
//   own, other            optical depths of the whole way through even air of the eye's densities
//   own_rise, other_rise  what densities fall by, as exponents, over the way
// The second layer's fading is a cubic in the first's density with the right values and slopes at both ends; slopes are held to
// where the cubic does not swing. A level way, the other branch, is exact. [Preetham1999, eq. 6 to 9]
FN Number inscattered_share(Number own, Number own_rise, Number other, Number other_rise) {
    if (max(abs(own_rise), abs(other_rise)) < 1e-3) return layer_share(own + other);
    Number share = layer_share(own_rise);
    Number end = exp(-1.0 * other * layer_share(other_rise));
    Number fall = end - 1.0;
    Number first_slope = max(-1.0 * other * share, 3.0 * fall);
    Number last_slope = max(-1.0 * end * other * share * exp(min(own_rise - other_rise, Number(60.0))), 3.0 * fall);
    Number depth = own * share;
    Number mean = exponential_moment(0, depth) + first_slope * exponential_moment(1, depth);
    mean += (3.0 * fall - 2.0 * first_slope - last_slope) * exponential_moment(2, depth);
    mean += (first_slope + last_slope - 2.0 * fall) * exponential_moment(3, depth);
    return share * mean;
}
