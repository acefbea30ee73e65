#include "celestial/eclipse.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/quadrature.h"
#include "units/units.h"

namespace airlight {

// Factored as Heron's area is, and angles by their halves' tangents: arc cosines lose half their digits where disks touch.
double disks_in_common(double a, double b, double d) {
    const double p = a + b - d, q = d + a - b, s = d - a + b, t = d + a + b;
    if (p <= 0.0) return 0.0;
    const double smaller = std::min(a, b);
    if (q <= 0.0 || s <= 0.0) return pi * smaller * smaller;
    return 2.0 * (a * a * std::atan(std::sqrt(p * s / (q * t))) + b * b * std::atan(std::sqrt(p * q / (s * t)))) -
           0.5 * std::sqrt(p * q * s * t);
}

CoveredSun covered_sun(double separation, double sun, double moon) {
    assert(separation >= 0.0 && sun > 0.0 && moon >= 0.0);
    static const GaussRule rule = gauss_rule(24, 0.0, 1.0);
    const double d = separation / sun, r = moon / sun;
    const double disk = disks_in_common(1.0, r, d) / pi;
    CoveredSun covered{disk, -disk, -disk};
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const double mu = rule.nodes[i], area = disks_in_common(std::sqrt(1.0 - mu * mu), r, d) / pi;
        covered.first += rule.weights[i] * area;
        covered.second += rule.weights[i] * 2.0 * (1.0 - mu) * area;
    }
    return covered;
}

double sunlight_left(const CoveredSun& covered, double dark_1, double dark_2) {
    const double whole = 1.0 - dark_1 / 3.0 - dark_2 / 6.0;
    return std::clamp(1.0 - (covered.disk + dark_1 * covered.first + dark_2 * covered.second) / whole, 0.0, 1.0);
}

}  // namespace airlight
