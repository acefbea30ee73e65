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

InterpolatingRule interpolating_rule(int n) {
    const GaussRule gauss = gauss_rule(n);
    const auto count = static_cast<std::size_t>(n);
    // Legendre polynomials of degree 0 to n at each node.
    std::vector<std::vector<double>> p(count, std::vector<double>(count + 1, 1.0));
    for (std::size_t k = 0; k < count; ++k) {
        const double x = gauss.nodes[k];
        p[k][1] = x;
        for (std::size_t l = 2; l <= count; ++l)
            p[k][l] = ((2.0 * static_cast<double>(l) - 1.0) * x * p[k][l - 1] - (static_cast<double>(l) - 1.0) * p[k][l - 2]) /
                      static_cast<double>(l);
    }
    InterpolatingRule rule;
    for (std::size_t k = 0; k < count; ++k) {
        rule.nodes.push_back(0.5 * (gauss.nodes[k] + 1.0));
        rule.weights.push_back(0.5 * gauss.weights[k]);
        rule.up_to.emplace_back();
        for (std::size_t j = 0; j < count; ++j) {
            double sum = gauss.nodes[k] + 1.0;  // degree 0
            for (std::size_t l = 1; l < count; ++l) sum += p[j][l] * (p[k][l + 1] - p[k][l - 1]);
            rule.up_to[k].push_back(0.25 * gauss.weights[j] * sum);
        }
    }
    return rule;
}

}  // namespace airlight
