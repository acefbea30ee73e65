// Every model, one function a file: each tells its card and how it is made.
#pragma once

#include "models/model.h"

namespace airlight {

Model reference_model();
Model tables_model();
Model perez1993_model();
Model preetham1999_model();
Model cie2003_model();
Model hipiny2006_model();
Model hosek2012_model();
Model prague2021_model();
Model bruneton2008_model();
Model hillaire2020_model();
Model airlight_model();

}  // namespace airlight
