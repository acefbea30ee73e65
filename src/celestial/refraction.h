// How air bends the rays from what stands outside of it. docs/theory.md, section 7.4.
// Uses the description of the air, of which molecules alone bend.
#pragma once

#include <vector>

#include "atmosphere/atmosphere.h"

namespace airlight {

// Angles are elevations, in radians from the horizontal at the eye; the eye stands at an altitude >= 0, in the air or above it.

// Of the lowest ray that does not meet the ground.
double apparent_horizon(const Atmosphere& air, Length eye);

// How much lower than its apparent elevation, from the apparent horizon to pi / 2, something stands outside of the air; >= 0.
// A ray keeps n r cos(elevation), n being the refractive index and r the distance from the centre; it is followed from the eye outward by
// its own slope [AuerStandish2000, eq. 3], on which the horizon and the perigee are places like any other. n - 1 is as large as Earth's air
// of the same Rayleigh scattering has it at 550 nm.
double bending(const Atmosphere& air, Length eye, double apparent_elevation);

// Bending at elevations horizon + (pi / 2 - horizon) u^4 for u from 0 to 1 in even steps, both ends included: [count].
struct BendingTable {
    double horizon;
    std::vector<double> bending;
};
BendingTable bending_table(const Atmosphere& air, Length eye, int count);

}  // namespace airlight
