// The run-time parts of models of the sky, read as physics/f64.h reads the physics.
#pragma once

#include "physics/f64.h"

namespace airlight::f64 {

#include "physics/models/text.inc"

}  // namespace airlight::f64
