// The air in real time: for each eye and sun the model `airlight` marches the rays of a small grid of directions, at all wavelengths, and
// keeps their colours at some places on the way; pixels look them up. From the ground to space.
// docs/decisions/0010-air-methods.md. Uses models, sky (the rows of directions) and gpu.
#pragma once

#include <memory>

#include "core/result.h"
#include "render/air_method.h"
#include "transport/tables.h"

namespace airlight::render {

// `colours`: of radiance at each wavelength of the tables.
Result<std::unique_ptr<AirMethod>> airlight_air(const Tables& tables, std::span<const Vec3> colours);

}  // namespace airlight::render
