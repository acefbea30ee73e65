#include "transport/view_rule.h"

#include <cmath>

#include "core/quadrature.h"

namespace airlight {

std::vector<double> view_edges(const Shell& shell, const DensityTable& densities, double altitude_m) {
    std::vector<double> edges;
    const auto add = [&](double lower) { edges.push_back(pi / 2.0 + std::acos((shell.bottom_m + lower) / (shell.bottom_m + altitude_m))); };
    for (auto jump = densities.jumps_m().rbegin(); jump != densities.jumps_m().rend(); ++jump)
        if (*jump <= altitude_m) add(*jump);
    add(0.0);
    return edges;
}

ViewRule view_rule(const HarmonicLayout& layout, const ViewAngles& angles, const std::vector<double>& edges) {
    ViewRule rule;
    const auto add = [&](int count, double from, double range) {
        const GaussRule gauss = gauss_rule(count, 0.0, 1.0);
        for (std::size_t i = 0; i < gauss.nodes.size(); ++i) {
            const double s = gauss.nodes[i];
            const double angle = from + range * s * s;
            const double weight = gauss.weights[i] * 2.0 * s * std::abs(range) * std::sin(angle);
            rule.angles.push_back({std::cos(angle), static_cast<float>(weight), legendre_values(layout, std::cos(angle))});
        }
    };
    add(angles.sky, edges.front(), -edges.front());
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) add(angles.layer, edges[i], edges[i + 1] - edges[i]);
    add(angles.ground, edges.back(), pi - edges.back());
    return rule;
}

}  // namespace airlight
