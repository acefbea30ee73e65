// How far a model is from the truth under one condition.
// Uses the truth, colours as the eye sees them, and any sky.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "eval/truth.h"
#include "spectrum/colour_weights.h"

namespace airlight {

// Over the directions that the model answers, of those on one side of the horizon. Left out: what is darker than 1e-8 of the
// solar irradiance per steradian (of the sun's illuminance, for colours), which no eye and no reference tells from black.
struct Score {
    int asked = 0, answered = 0;     // directions
    double relative_rmse = 0.0;      // sqrt(max(0, mean((model / truth - 1)^2) - mean((error / truth)^2))), over wavelengths, too
    double plain_rmse = 0.0;         // the same with nothing taken off
    double noise = 0.0;              // the truth's own standard error, sqrt(mean((error / truth)^2))
    double bias = 0.0;               // mean(model / truth - 1)
    double spectral_rmse = 0.0;      // W m-2 sr-1 nm-1, nothing taken off
    double luminance_rmse = 0.0;     // relative
    double chromaticity_rmse = 0.0;  // in u'v'
    double colour_difference = 0.0;  // mean of CIEDE2000; white is D65 as bright as the brightest direction of the truth
};

struct Illuminance {
    double direct_lx, diffuse_lx;
};
Illuminance illuminance(const IrradianceEstimate& light, const ColourWeights& weights);

struct Verdict {
    std::optional<Score> sky, ground;           // above and below the horizon; none if no direction is answered
    std::string refusal;                        // why the first direction that is not answered is not
    std::vector<std::optional<double>> excess;  // relative, of luminance, in each direction
    std::optional<Illuminance> horizontal;      // on a level plane at the eye
    std::string horizontal_refusal;
};

Verdict judged(const Sky& model, const SkyTruth& truth, const Sun& sun, const ColourWeights& weights);

}  // namespace airlight
