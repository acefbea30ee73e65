// The air exactly: each pixel's ray is marched by the text of the model `airlight`, four wavelengths at a time; their sum is a colour.
// From the ground to space. docs/theory.md, section 10.1. The truth for what is faster.
#pragma once

#include <memory>

#include "render/air_method.h"
#include "transport/tables.h"

namespace airlight::render {

// `colours`: of radiance at each wavelength of the tables.
std::unique_ptr<AirMethod> exact_air(const Tables& tables, std::span<const Vec3> colours);

}  // namespace airlight::render
