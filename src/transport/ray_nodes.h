// Where a ray through the air is sampled: nodes of Gauss's rules on its pieces, and the columns of air up to each node.
// Theory: docs/theory.md, section 5.2. Uses the density table; knows nothing of wavelengths or of light.
#pragma once

#include <array>

#include "physics/f64.h"
#include "transport/density_table.h"

namespace airlight {

// The spherical shell that rays go through.
struct Shell {
    double bottom_m;  // radius of the ground
    double top_m;     // altitude of the top
};

// A ray from a point within the air, in the coordinates of docs/conventions.md.
struct Ray {
    double altitude_m;       // 0 to the top
    double mu;               // cosine of its zenith angle
    double mu_s;             // cosine of the sun's zenith angle
    double nu;               // cosine of the angle between them
    double limit_m = 1e300;  // where it ends, if it has not met the ground or left the air before
};

// The planet's shadow is a cylinder whose axis points from the sun and whose radius is the ground's. Around it lies light that has grazed
// dense air: it rises from nothing to nearly all of the sun's within two more cylinders. Their heights above the ground, as shares of
// that of the air.
inline constexpr std::array<double, 3> shadow_edges = {0.0, 0.06, 0.2};

// A ray is cut at its perigee, where it enters or leaves the planet's shadow and the cylinders around it, where a density jumps, and some mean free paths after
// its start and after each jump; within a piece the nodes crowd, in altitude, quadratically towards its lower end. So neither the
// thin haze at the ground nor the first kilometres of a horizontal ray is stepped over, which steps of equal length do.
struct RayNodes {
    static constexpr int max_per_piece = 24;
    static constexpr int max_pieces = 28;
    static constexpr int capacity = max_per_piece * max_pieces;

    int count = 0;
    bool meets_ground = false;  // before its limit
    float end_distance_m = 0.0f;
    float end_altitude_m = 0.0f;
    float end_mu_s = 0.0f;  // cosine of the sun's zenith angle where the ray ends
    float altitude_m[capacity];
    float mu[capacity];  // of the ray itself
    float mu_s[capacity];
    float distance_m[capacity];  // from the start
    float length_m[capacity];    // the quadrature weight
    float density[capacity][max_parts];
    float column_m[capacity][max_parts];  // integral of the density from the start to the node
    float total_column_m[max_parts];      // to the end
};

// The greatest extinction of each part of the air, in 1/m where its density is 1, at the wavelengths that a ray is sampled for:
// it places the cuts by free paths. With zeros there are none.
using Opacity = std::array<float, max_parts>;

// `nodes_per_piece`: 2 to RayNodes::max_per_piece.
void sample_ray(const Shell& shell, const Ray& ray, const DensityTable& densities, const Opacity& opacity, int nodes_per_piece,
                RayNodes& nodes);

// Moves a ray whose start lies above the air to where it enters; false if it misses the air. Exact to a few parts in 1e16 of the distance.
bool enter_air(const Shell& shell, Ray& ray);

}  // namespace airlight
