#include "eval/ciede2000.h"

#include <cmath>

#include "units/units.h"

namespace airlight {

namespace {

// The cube root, with the straight line of the CIE below (6/29)^3.
double lab_response(double t) {
    constexpr double knee = 6.0 / 29.0;
    return t > knee * knee * knee ? std::cbrt(t) : t / (3.0 * knee * knee) + 4.0 / 29.0;
}

// Chroma and hue (radians, 0 to 2 pi; 0 for grey) with the a axis stretched near grey: eq. 2 to 7.
struct ChromaHue {
    double chroma, hue;
};
ChromaHue chroma_hue(Lab colour, double stretch) {
    const double a = colour.a * (1.0 + stretch);
    if (a == 0.0 && colour.b == 0.0) return {0.0, 0.0};
    const double hue = std::atan2(colour.b, a);
    return {std::hypot(a, colour.b), hue < 0.0 ? hue + 2.0 * pi : hue};
}

// x^7 / (x^7 + 25^7)
double seventh_power_share(double x) {
    const double x7 = std::pow(x, 7.0);
    return x7 / (x7 + 6103515625.0);
}

// Eq. 10: the hue of the second less that of the first, the short way round.
double hue_difference(ChromaHue one, ChromaHue other) {
    if (one.chroma * other.chroma == 0.0) return 0.0;
    const double d = other.hue - one.hue;
    return d > pi ? d - 2.0 * pi : d < -pi ? d + 2.0 * pi : d;
}

// Eq. 14.
double mean_hue(ChromaHue one, ChromaHue other) {
    const double sum = one.hue + other.hue;
    if (one.chroma * other.chroma == 0.0) return sum;
    if (std::abs(one.hue - other.hue) <= pi) return 0.5 * sum;
    return sum < 2.0 * pi ? 0.5 * sum + pi : 0.5 * sum - pi;
}

}  // namespace

Lab lab(Xyz colour, Xyz white) {
    const double x = lab_response(colour.x / white.x), y = lab_response(colour.y / white.y), z = lab_response(colour.z / white.z);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

double ciede2000(Lab one, Lab other) {
    const double mean_plain_chroma = 0.5 * (std::hypot(one.a, one.b) + std::hypot(other.a, other.b));
    const double stretch = 0.5 * (1.0 - std::sqrt(seventh_power_share(mean_plain_chroma)));
    const ChromaHue p = chroma_hue(one, stretch), q = chroma_hue(other, stretch);

    const double dl = other.l - one.l, dc = q.chroma - p.chroma;
    const double dh = 2.0 * std::sqrt(p.chroma * q.chroma) * std::sin(0.5 * hue_difference(p, q));

    const double l = 0.5 * (one.l + other.l) - 50.0, c = 0.5 * (p.chroma + q.chroma), h = mean_hue(p, q);
    const double t = 1.0 - 0.17 * std::cos(h - 30.0 * deg) + 0.24 * std::cos(2.0 * h) + 0.32 * std::cos(3.0 * h + 6.0 * deg) -
                     0.20 * std::cos(4.0 * h - 63.0 * deg);
    const double blue = (h / deg - 275.0) / 25.0;
    const double turn = -2.0 * std::sqrt(seventh_power_share(c)) * std::sin(60.0 * deg * std::exp(-blue * blue));
    const double weighted_l = dl / (1.0 + 0.015 * l * l / std::sqrt(20.0 + l * l));
    const double weighted_c = dc / (1.0 + 0.045 * c), weighted_h = dh / (1.0 + 0.015 * c * t);
    return std::sqrt(weighted_l * weighted_l + weighted_c * weighted_c + weighted_h * weighted_h + turn * weighted_c * weighted_h);
}

}  // namespace airlight
