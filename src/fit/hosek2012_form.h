// The nine-parameter form fitted to the skies of many suns at one wavelength, albedo and turbidity. [HosekWilkie2012]
// Uses least squares and the form of the file (models/hosek2012_data.h); knows nothing of how skies are computed.
#pragma once

#include <array>
#include <span>

#include "models/hosek2012_data.h"

namespace airlight {

inline constexpr std::size_t bezier_points = 6;

// The weights of the control points for a sun at a zenith angle of 0 to pi / 2; they are >= 0, and their sum is 1.
std::array<double, bezier_points> bezier_weights(double sun_zenith);

// Control points of each coefficient, in the order of hosek2012_coefficients.
using HosekCurves = Hosek2012Points;

// The form's arguments and what it should give there.
struct HosekSample {
    double sun_zenith;
    double mu;     // cosine of the view's zenith angle, >= 0
    double gamma;  // angle between view and sun
    double radiance;
    double weight;
};

// By the text of the model, physics/models/hosek2012.glsl.
double hosek_radiance(const HosekCurves& curves, double sun_zenith, double mu, double gamma);

// The curves of the least mean square of relative differences. Those of a similar sky, if there are any, are where the search
// begins, and of two as good answers the nearer one is taken: so that what lies between two turbidities is as good.
HosekCurves fitted_hosek(std::span<const HosekSample> samples, const HosekCurves* similar);

}  // namespace airlight
