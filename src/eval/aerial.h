// Aerial perspective judged: what the air between an eye and a point lets through and adds, by the reference and by a model.
// By day alone, and from within the air. Uses the reference, conditions and any sky.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "eval/condition.h"

namespace airlight {

// Of the points that are looked at, along each of three directions: over the horizon towards the sun and away from it, and down.
inline constexpr std::array<double, 3> aerial_distances_m = {2e3, 10e3, 50e3};

// One look at a point. The transmittance is exact, the light that the air adds an estimate.
struct AerialTruth {
    View view;
    std::size_t distance;  // which of aerial_distances_m
    std::vector<double> transmittance;
    RadianceEstimate inscattered;
};

// Whether aerial perspective is judged under a condition: by day, from within the air.
bool aerial_judged(const Atmosphere& atmosphere, const Condition& condition);

// Points behind the ground or outside of the air are left out.
Result<std::vector<AerialTruth>> aerial_truths(const Reference& reference, const Atmosphere& atmosphere, const Condition& condition,
                                               const ReferenceSettings& settings, const Progress& progress = {});

// Over views at points at one distance: relative errors of the light as in Score, differences of transmittances as they are.
struct AerialScore {
    int asked = 0, answered = 0;
    double light_rmse = 0.0;  // relative, less the truth's variance
    double noise = 0.0;
    double transmittance_rmse = 0.0;
};
// One for each of aerial_distances_m; `refusal`: why the first view that is not answered is not.
struct AerialVerdict {
    std::array<AerialScore, aerial_distances_m.size()> at;
    std::string refusal;
};
AerialVerdict judged_aerial(const Sky& model, const std::vector<AerialTruth>& truths);

}  // namespace airlight
