// Gauss's rules for integrals over an interval.
// Uses nothing.
#pragma once

#include <vector>

namespace airlight {

// Nodes in (low, high), increasing, and their weights: the integral of any polynomial of degree 2 n - 1 is exact.
struct GaussRule {
    std::vector<double> nodes;
    std::vector<double> weights;
};

// n >= 1 points on [low, high].
GaussRule gauss_rule(int n, double low = -1.0, double high = 1.0);

}  // namespace airlight
