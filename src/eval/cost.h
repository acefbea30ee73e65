// What a model costs: what is computed ahead, what stays in memory, and a direction.
// Uses any sky. Times are of processor cores, so that what else runs on the machine does not enter.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "eval/condition.h"

namespace airlight {

// Of making a sky.
struct MakingCost {
    double core_seconds = 0.0;  // of all cores together
    std::size_t bytes = 0;      // that stay allocated
};

// Makes a sky and measures that.
Result<std::unique_ptr<Sky>> measured_making(const std::function<Result<std::unique_ptr<Sky>>()>& make, MakingCost& cost);

// Of asking it, on one core.
struct AskingCost {
    double dome_seconds = 0.0;       // before the first direction of an eye and a sun
    double direction_seconds = 0.0;  // each, in a batch of up to 20 000
};
// A picture of 200 x 100 directions.
double picture_seconds(const AskingCost& cost);

// Fails if the sky does not answer under this condition.
Result<AskingCost> asking_cost(const Sky& sky, const Condition& condition);

}  // namespace airlight
