// The air by Hillaire's light: for each eye and sun his march with its table of higher orders fills a grid of rays, and pixels look it up.
// From the ground to space. [Hillaire2020]; src/models/hillaire2020.cpp says what the model leaves out.
//
//   differs   The sky-view table and the aerial-perspective volume of the paper are one grid (render/air_ray_grid.h), which reaches as
//             far as the air does and nowhere mixes sky and ground; light is red, green and blue from all wavelengths. The sky's light
//             on surfaces, which the paper leaves open, is that of his sky over the ground.
#pragma once

#include <memory>

#include "core/result.h"
#include "render/air_method.h"

namespace airlight::render {

Result<std::unique_ptr<AirMethod>> hillaire2020_air(const ColouredAir& air);

}  // namespace airlight::render
