// The physics in double precision, sixteen wavelengths at a time: the truth.
// The text is physics/*.glsl; f32.h and a GLSL compiler read the same lines.
#pragma once

#include "physics/readings/look_up.h"
#include "physics/readings/macros.h"
#include "units/quantity.h"
#include "units/spectral.h"

namespace airlight::f64 {

using Rep = double;
inline constexpr int N = 16;
#include "physics/readings/names.inc"
#include "physics/readings/text.inc"

}  // namespace airlight::f64
