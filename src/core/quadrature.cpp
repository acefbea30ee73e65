#include "core/quadrature.h"

#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

namespace airlight {

GaussRule gauss_rule(int n, double low, double high) {
    assert(n >= 1);
    GaussRule rule;
    const double half = 0.5 * (high - low);
    for (int i = n; i-- > 0;) {
        // Newton's method on the Legendre polynomial P_n, from a start close to its root.
        double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
        double slope = 0.0;
        for (int step = 0; step < 100; ++step) {
            double p = 1.0;
            double previous = 0.0;
            for (int l = 1; l <= n; ++l) previous = std::exchange(p, ((2 * l - 1) * x * p - (l - 1) * previous) / l);
            slope = n * (x * p - previous) / (x * x - 1.0);
            const double shift = p / slope;
            x -= shift;
            if (std::abs(shift) < 1e-15) break;
        }
        rule.nodes.push_back(low + half * (x + 1.0));
        rule.weights.push_back(half * 2.0 / ((1.0 - x * x) * slope * slope));
    }
    return rule;
}

}  // namespace airlight
