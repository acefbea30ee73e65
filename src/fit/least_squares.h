// Nonlinear least squares by Levenberg and Marquardt's method: the fit of any formula to samples.
// Uses Eigen (docs/decisions/0006-fits.md); knows nothing of light.
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace airlight {

struct LeastSquares {
    int residuals = 0;  // at least as many as parameters
    // Writes the residuals of parameters: [residuals].
    std::function<void(std::span<const double> parameters, std::span<double> residuals)> evaluate;
    // Writes their derivatives, parameter by parameter: [parameters][residuals]. Without it, forward differences are taken.
    std::function<void(std::span<const double> parameters, std::span<double> derivatives)> differentiate = {};
    int evaluations = 200;    // at most
    double tolerance = 1e-8;  // of a step, or of the gain of one, relative to the whole
};

struct LeastSquaresFit {
    std::vector<double> parameters;
    double root_mean_square;  // of the residuals
};

// The parameters of the least sum of squares near `start`: where steps have become that small, or the
// evaluations are used up. Deterministic. A residual that is not finite at `start` is our own fault.
LeastSquaresFit least_squares(const LeastSquares& problem, std::vector<double> start);

}  // namespace airlight
