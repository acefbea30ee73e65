// Every function of the shared text with its domain and its bounds: one line each, one list for a file of physics/.
// The bounds are derived in point_laws.cpp.
#pragma once

#include <vector>

#include "tools/point_law.h"

namespace airlight::test {

std::vector<PointLaw> shell_laws();
std::vector<PointLaw> density_laws();
std::vector<PointLaw> phase_laws();
std::vector<PointLaw> map_laws();
std::vector<PointLaw> model_laws();  // of physics/models

}  // namespace airlight::test
