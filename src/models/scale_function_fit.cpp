#include "models/scale_function_fit.h"

#include <algorithm>
#include <cmath>

#include "core/quadrature.h"
#include "physics/models/f64.h"

namespace airlight {

namespace {

double log_scale(Length bottom_radius, Length top_altitude, Length scale_height, double x) {
    const auto length = [](Length l) { return f64::Length::of(l.value); };
    const f64::ScatteringSpectrum none(f64::ScatteringSpectrum::Scalar::of(0.0));
    const f64::ExponentialAir air =
        f64::exponential_air(length(bottom_radius), length(top_altitude), length(scale_height), length(scale_height), none, none);
    const f64::Length ground = 0.0 * f64::m;
    const f64::AirColumns column =
        f64::kaneda1991_columns(air, ground, 1.0 - x, f64::distance_to_top(ground, 1.0 - x, air.bottom, air.top), 512);
    return std::log(column.air.value / scale_height.value);
}

// The shifted Legendre polynomials of degree 0 to 4, as powers of x on [0, 1].
constexpr double legendre[5][5] = {{1, 0, 0, 0, 0}, {-1, 2, 0, 0, 0}, {1, -6, 6, 0, 0}, {-1, 12, -30, 20, 0}, {1, -20, 90, -140, 70}};

double polynomial(const double* c, double x) { return c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * c[4]))); }

}  // namespace

ScaleFunctionFit fit_scale_function(Length bottom_radius, Length top_altitude, Length scale_height) {
    // The polynomials are orthogonal: the least-squares fit is a projection on each.
    const GaussRule rule = gauss_rule(96, 0.0, 1.0);
    std::array<double, 96> values;
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = log_scale(bottom_radius, top_altitude, scale_height, rule.nodes[k]);
    ScaleFunctionFit fit{};
    for (int l = 0; l < 5; ++l) {
        double moment = 0.0;
        for (std::size_t k = 0; k < values.size(); ++k) moment += rule.weights[k] * values[k] * polynomial(legendre[l], rule.nodes[k]);
        for (std::size_t power = 0; power < 5; ++power) fit.coefficients[power] += (2 * l + 1) * moment * legendre[l][power];
    }
    double squares = 0.0;
    for (std::size_t k = 0; k < values.size(); ++k) {
        const double residual = std::abs(polynomial(fit.coefficients.data(), rule.nodes[k]) - values[k]);
        squares += rule.weights[k] * residual * residual;
        fit.worst_residual = std::max(fit.worst_residual, residual);
    }
    fit.mean_residual = std::sqrt(squares);
    return fit;
}

}  // namespace airlight
