// The physics in the GPU's arithmetic (float, no contraction), sixteen wavelengths at a time.
// The text is physics/*.glsl; f64.h and a GLSL compiler read the same lines.
#pragma once

#include "physics/readings/look_up.h"
#include "physics/readings/macros.h"
#include "units/quantity.h"
#include "units/spectral.h"

namespace airlight::f32 {

using Rep = float;
inline constexpr int N = 16;
#include "physics/readings/names.inc"
#include "physics/readings/text.inc"

}  // namespace airlight::f32
