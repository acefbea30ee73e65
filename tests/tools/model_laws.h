// The laws of the run-time parts of models (physics/models), one list for a family of models.
#pragma once

#include "tools/point_laws.h"

namespace airlight::test {

std::vector<PointLaw> analytic_model_laws();  // formulas fitted to skies
std::vector<PointLaw> table_model_laws();     // look-ups in tables computed ahead
std::vector<PointLaw> marched_model_laws();   // marches through exponential air, and closed forms in constant air

}  // namespace airlight::test
