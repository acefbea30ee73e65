// O'Neil's scale function fitted to any planet and scale height. [ONeil2005]
#pragma once

#include <array>

#include "units/units.h"

namespace airlight {

// The logarithm of (column from the ground to the top / scale height) as a polynomial of x = 1 - mu.
struct ScaleFunctionFit {
    std::array<double, 5> coefficients;
    double mean_residual;   // root mean square over x of the logarithm's error: relative, of the column
    double worst_residual;  // at any x
};

// Least squares over 0 <= x <= 1, with columns by integration along the ray.
ScaleFunctionFit fit_scale_function(Length bottom_radius, Length top_altitude, Length scale_height);

}  // namespace airlight
