// The light of the sky on surfaces above the ground, as the pass of air has it (docs/decisions/0019-objects.md).
#pragma once

#include <vector>

#include "sky/sky.h"
#include "tools/must.h"

namespace airlight::test {

// What is left of the ground's skylight at an altitude: the share of the light that the air above takes of what the whole air takes.
inline std::vector<double> skylight_left(const Sky& sky, Length altitude) {
    std::vector<double> left = must(sky.sunlight_transmittance(altitude, 0.0));
    const std::vector<double> whole = must(sky.sunlight_transmittance(0.0 * m, 0.0));
    for (std::size_t w = 0; w < left.size(); ++w) left[w] = (1.0 - left[w]) / (1.0 - whole[w]);
    return left;
}

}  // namespace airlight::test
