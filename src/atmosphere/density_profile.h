// How the density of a constituent varies with altitude, relative to its reference.
// Theory: docs/theory.md, section 2. Uses physics (the laws) and curves.
#pragma once

#include <variant>
#include <vector>

#include "units/curve.h"
#include "units/units.h"

namespace airlight {

// 1 at the ground, 1/e at one scale height; 0 above `top` (a cut-off; the atmosphere's own top cuts too).
struct ExponentialProfile {
    Length scale_height;
    Length top = 1e9 * m;
    friend bool operator==(const ExponentialProfile&, const ExponentialProfile&) = default;
};

// 1 between two altitudes, 0 elsewhere.
struct LayerProfile {
    Length low;
    Length high;
    friend bool operator==(const LayerProfile&, const LayerProfile&) = default;
};

// 0 at `low`, 1 at `peak`, 0 at `high`, straight between.
struct TriangleProfile {
    Length low;
    Length peak;
    Length high;
    friend bool operator==(const TriangleProfile&, const TriangleProfile&) = default;
};

// Relative densities (>= 0) at altitudes; between two positive ones the logarithm is linear, else the density is.
// Below the first and above the last sample the density is that of the nearest one below, and 0 above.
struct TabulatedProfile {
    Curve<Length, Number> densities = Curve<Length, Number>::constant(0.0);
    friend bool operator==(const TabulatedProfile&, const TabulatedProfile&) = default;
};

using DensityProfile = std::variant<ExponentialProfile, LayerProfile, TriangleProfile, TabulatedProfile>;

// The relative density at altitude h >= 0.
double relative_density(const DensityProfile& profile, Length h);

// The altitudes, increasing, at which the density or its slope jumps.
std::vector<Length> kinks(const DensityProfile& profile);

// The altitudes, increasing, at which the density itself jumps.
std::vector<Length> jumps(const DensityProfile& profile);

// The integral of the relative density over [0, top]: the depth of a layer of density one that holds as much.
// Relative error below 1e-9.
Length column_depth(const DensityProfile& profile, Length top);

}  // namespace airlight
