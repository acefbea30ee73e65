// The directions around a point by which light is integrated over the sphere: zenith angles with their weights.
// Theory: docs/theory.md, section 5.3. Uses harmonics, ray nodes (the shell) and the density table.
#pragma once

#include <vector>

#include "transport/harmonics.h"
#include "transport/ray_nodes.h"

namespace airlight {

// How many zenith angles stand for the sky, for the ground, and between the edge of a layer seen from above and the next one's, or the
// horizon.
struct ViewAngles {
    int sky, ground, layer;
};

// The directions at one altitude, with their solid angles but for the azimuth's share.
struct ViewRule {
    struct Angle {
        double mu;
        float weight;                 // d mu
        std::vector<float> legendre;  // [layout.count()]
    };
    std::vector<Angle> angles;
};

// Zenith angles at which light jumps around a point, increasing: the edge of each layer that ends below, and last the horizon.
std::vector<double> view_edges(const Shell& shell, const DensityTable& densities, double altitude_m);

// `edges`: view_edges(). Sky and ground apart, both crowding towards the edge between them.
ViewRule view_rule(const HarmonicLayout& layout, const ViewAngles& angles, const std::vector<double>& edges);

}  // namespace airlight
