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

// Gauss's rule on [0, 1], and the integrals from 0 to each node of the polynomial through all samples: the integral up to node k
// of what has the values f_j at the nodes is about sum over j of up_to[k][j] f_j.
struct InterpolatingRule {
    std::vector<double> nodes;
    std::vector<double> weights;
    std::vector<std::vector<double>> up_to;  // [node][sample]
};

// n >= 1 points.
InterpolatingRule interpolating_rule(int n);

}  // namespace airlight
