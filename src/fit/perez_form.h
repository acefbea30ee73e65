// Perez's formula fitted to the sky of one sun after another. [Perez1993]
// Uses least squares and the text of the model; knows nothing of how skies are computed.
#pragma once

#include <span>
#include <vector>

#include "models/perez1993_data.h"

namespace airlight {

// The formula's arguments and what it should give there.
struct PerezSample {
    double mu;  // cosine of the view's zenith angle, > 0
    double nu;  // of the angle from the sun
    double value;
    double weight;
};

// The forms of the least mean square of relative differences, a sun each: the best of searches from several kinds of sky, and from where
// the sun before ended.
std::vector<PerezForm> fitted_perez(std::span<const std::vector<PerezSample>> suns);

}  // namespace airlight
