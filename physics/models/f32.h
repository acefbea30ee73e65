// The run-time parts of models of the sky, read as physics/f32.h reads the physics.
#pragma once

#include "physics/f32.h"

namespace airlight::f32 {

#include "physics/models/text.inc"

}  // namespace airlight::f32
