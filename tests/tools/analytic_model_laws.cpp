#include "physics/models/f32.h"
#include "physics/models/f64.h"
#include "tools/domain.h"
#include "tools/model_laws.h"

// The run-time parts of models. Bounds are counted as in point_laws.cpp; formulas here are long, so a bound on float is
// what was found, doubled, and a comment names the step that loses most.

namespace airlight::test {

namespace {

std::vector<double> zenith_cosines() { return {1.0, 0.9, 0.5, 0.1, 0.01, 1e-3, 0.0}; }
std::vector<double> sun_zeniths() { return {0.0, 0.1, 0.5, 1.0, 1.4, 1.55, 1.5707}; }

}  // namespace

std::vector<PointLaw> analytic_model_laws() {
    return {
        // A root and a polynomial.
        POINT_LAW(angle_of_cosine, combinations({cosines()}), 20, 1),
        MODEL_LAW("preetham1999: luminance", 4, preetham1999_sky(preetham1999(x[0], x[1]), x[2], x[3]).luminance,
                  combinations({{1.7, 2.53, 6.0, 10.0}, sun_zeniths(), zenith_cosines(), cosines()}), 100, 100),
        MODEL_LAW("preetham1999: x", 4, preetham1999_sky(preetham1999(x[0], x[1]), x[2], x[3]).x,
                  combinations({{1.7, 2.53, 6.0, 10.0}, sun_zeniths(), zenith_cosines(), cosines()}), 100, 100),
    };
}

}  // namespace airlight::test
