#include "physics/models/f32.h"
#include "physics/models/f64.h"
#include "tools/domain.h"
#include "tools/model_laws.h"

// The run-time parts of models. Bounds are counted as in point_laws.cpp; formulas here are long, so a bound on float is
// what was found, doubled, and a comment names the step that loses most.

namespace airlight::test {

namespace {

std::vector<double> zenith_cosines() { return {1.0, 0.9, 0.5, 0.1, 0.01, 1e-3, 0.0}; }
std::vector<double> rises() { return {0.0, 1e-6, 1e-3, 0.02, 0.0499, 0.0501, 0.1, 0.5, 1.0, 5.0, 60.0}; }
std::vector<double> depths() { return {0.0, 1e-4, 0.01, 0.1, 0.5, 1.0, 2.9, 3.1, 8.0, 20.0}; }
std::vector<double> sun_angles() { return {0.0, 0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0, 1.2, 1.4, 1.5, 1.55, 1.5707}; }
std::vector<double> sun_zeniths() { return {0.0, 0.1, 0.5, 1.0, 1.4, 1.55, 1.5707}; }

}  // namespace

std::vector<PointLaw> analytic_model_laws() {
    return {
        // A root and a polynomial.
        POINT_LAW(angle_of_cosine, combinations({cosines()}), 5, 1),
        // The power of the horizon's angle, and a cosine near zero.
        POINT_LAW(relative_air_mass, combinations({sun_angles()}), 4, 20),
        POINT_LAW(sky_clearness, combinations({{0.0, 1.0, 9.0}, {0.5, 1.0}, sun_zeniths()}), 8, 4),
        POINT_LAW(sky_brightness, combinations({{0.05, 0.3}, {1.0}, sun_zeniths()}), 4, 20),
        MODEL_LAW("preetham1999: luminance", 4, preetham1999_sky(preetham1999(x[0], x[1]), x[2], x[3]).luminance,
                  combinations({{1.7, 2.53, 6.0, 10.0}, sun_zeniths(), zenith_cosines(), cosines()}), 12, 100),
        MODEL_LAW("preetham1999: x", 4, preetham1999_sky(preetham1999(x[0], x[1]), x[2], x[3]).x,
                  combinations({{1.7, 2.53, 6.0, 10.0}, sun_zeniths(), zenith_cosines(), cosines()}), 12, 100),
        // The exponential of -20, whose last digit is twenty of the result's.
        POINT_LAW(preetham1999_sunlight, combinations({{1.0, 5.0, 36.0}, {0.38, 0.55, 0.7}, {1.7, 6.0}, {0.0, 0.03}}), 1, 170),
        // Above the branch 1 - exp(-rise) cancels.
        POINT_LAW(layer_share, combinations({rises()}), 11, 40),
        POINT_LAW(exponential_moment, combinations({{0.0, 1.0, 2.0, 3.0}, depths()}), 15, 6),
        POINT_LAW(inscattered_share, combinations({depths(), {0.0, 5e-4, 0.01, 0.3, 2.0, 20.0}, depths(), {0.0, 1e-3, 0.1, 3.0}}), 33, 28),
        POINT_LAW(hipiny2006_weight, combinations({{0.0, 10.0, 1000.0, 4000.0}, {0.0}, {4000.0, 30000.0}, {8000.0, 1200.0}}), 2, 4),
        // Three terms; where they cancel, their roundings remain.
        MODEL_LAW("dobashi1997: a series of cosines", 4, cosine_series(cosine_term(cosine_term(cosine_sum(x[3]), x[2]), x[1]), x[0]),
                  combinations({{1.0, 3.0}, {0.5, 0.2}, {0.1, 0.3}, {0.0, 1e-3, 0.5, 1.5, 1.6, 2.5, 3.1, 3.14159}}), 1, 1),
        // Roots of fractions, a product each, and the difference of two products.
        MODEL_LAW("dobashi1997: harmonics, orders 0 to 2", 2,
                  legendre_next(legendre_next(legendre_first(0, x[1]), 1, 0, x[1]), 2, 0, x[1]).here +
                      x[0] * legendre_next(legendre_first(1, x[1]), 2, 1, x[1]).here + x[0] * legendre_first(2, x[1]).here,
                  combinations({{0.5, 2.0}, zenith_cosines()}), 3, 4),
        // A cube root near the horizon, of a difference.
        POINT_LAW(hosek2012_place, combinations({sun_angles()}), 2, 20),
        MODEL_LAW("hosek2012: curve", 3, quintic_bezier(x[0], 0.5 * x[0], x[1], 2.0 * x[1], x[0] + x[1], x[1], x[2]),
                  combinations({{0.5, 1.0, 7.0}, {0.3, 2.0}, {0.0, 0.1, 0.3, 0.5, 0.9, 1.0}}), 5, 4),
        // The exponential of -500 at the horizon.
        POINT_LAW(hosek2012_gradation, combinations({{-1.2, -0.2}, {-5.0, -0.4}, zenith_cosines()}), 1, 20),
        POINT_LAW(hosek2012_aureole,
                  combinations({{2.0}, {-4.0, -1.0}, {0.3}, {0.01}, {0.2, 0.75, 1.3}, cosines(), {0.0, 0.01, 0.5, 1.5, 3.1}}), 3, 20),
    };
}

}  // namespace airlight::test
