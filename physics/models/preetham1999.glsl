// Preetham's sky: luminance and chromaticity by Perez's formula, each with coefficients linear in turbidity.
// What it is and leaves out: src/models/preetham1999.cpp. [Preetham1999, app. A.2]

struct ColourYxy {
    Number luminance;  // cd m-2
    Number x;
    Number y;
};

// All that does not depend on the direction: `scale` is the value at the zenith over Perez's formula there.
struct Preetham1999 {
    PerezCoefficients luminance;
    PerezCoefficients x;
    PerezCoefficients y;
    ColourYxy scale;
};

// For the sun at a zenith angle of 0 to pi / 2.
FN Preetham1999 preetham1999(Number turbidity, Number sun_zenith) {
    Number t = turbidity;
    Preetham1999 sky;
    sky.luminance.a = 0.1787 * t - 1.4630;
    sky.luminance.b = -0.3554 * t + 0.4275;
    sky.luminance.c = -0.0227 * t + 5.3251;
    sky.luminance.d = 0.1206 * t - 2.5771;
    sky.luminance.e = -0.0670 * t + 0.3703;
    sky.x.a = -0.0193 * t - 0.2592;
    sky.x.b = -0.0665 * t + 0.0008;
    sky.x.c = -0.0004 * t + 0.2125;
    sky.x.d = -0.0641 * t - 0.8989;
    sky.x.e = -0.0033 * t + 0.0452;
    sky.y.a = -0.0167 * t - 0.2608;
    sky.y.b = -0.0950 * t + 0.0092;
    sky.y.c = -0.0079 * t + 0.2102;
    sky.y.d = -0.0441 * t - 1.6537;
    sky.y.e = -0.0109 * t + 0.0529;

    Number s = sun_zenith;
    Number chi = (4.0 / 9.0 - t / 120.0) * (pi - 2.0 * s);
    Number luminance = 1000.0 * ((4.0453 * t - 4.9710) * sin(chi) / cos(chi) - 0.2155 * t + 2.4192);
    Number x2 = ((0.00166 * s - 0.00375) * s + 0.00209) * s;
    Number x1 = ((-0.02903 * s + 0.06377) * s - 0.03202) * s + 0.00394;
    Number x0 = ((0.11693 * s - 0.21196) * s + 0.06052) * s + 0.25886;
    Number y2 = ((0.00275 * s - 0.00610) * s + 0.00317) * s;
    Number y1 = ((-0.04214 * s + 0.08970) * s - 0.04153) * s + 0.00516;
    Number y0 = ((0.15346 * s - 0.26756) * s + 0.06670) * s + 0.26688;
    Number mu_s = cos(s);
    sky.scale.luminance = luminance / perez(sky.luminance, Number(1.0), mu_s, s);
    sky.scale.x = ((x2 * t + x1) * t + x0) / perez(sky.x, Number(1.0), mu_s, s);
    sky.scale.y = ((y2 * t + y1) * t + y0) / perez(sky.y, Number(1.0), mu_s, s);
    return sky;
}

// Towards a zenith angle of cosine mu >= 0, at an angle gamma from the sun, of cosine nu.
FN ColourYxy preetham1999_towards(IN(Preetham1999) sky, Number mu, Number nu, Number gamma) {
    ColourYxy colour;
    colour.luminance = sky.scale.luminance * perez(sky.luminance, mu, nu, gamma);
    colour.x = sky.scale.x * perez(sky.x, mu, nu, gamma);
    colour.y = sky.scale.y * perez(sky.y, mu, nu, gamma);
    return colour;
}

FN ColourYxy preetham1999_sky(IN(Preetham1999) sky, Number mu, Number nu) {
    return preetham1999_towards(sky, mu, nu, angle_of_cosine(nu));
}

// Linear amounts of the primaries of sRGB; (1, 1, 1) is its white at a luminance of 1 cd m-2.
struct LinearSrgb {
    Number r;
    Number g;
    Number b;
};

// From luminance and chromaticity by XYZ; the matrix is that of the primaries and of D65 (IEC 61966-2-1). Amounts below zero are kept.
FN LinearSrgb linear_srgb(IN(ColourYxy) colour) {
    Number scale = colour.luminance / colour.y;
    Number x = scale * colour.x;
    Number y = colour.luminance;
    Number z = scale * (1.0 - colour.x - colour.y);
    LinearSrgb rgb;
    rgb.r = 3.2409699 * x - 1.5373832 * y - 0.4986108 * z;
    rgb.g = 1.8759675 * y - 0.9692436 * x + 0.0415551 * z;
    rgb.b = 0.0556301 * x - 0.2039770 * y + 1.0569715 * z;
    return rgb;
}
