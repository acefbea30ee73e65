// Every model, one function a file: each tells its card and how it is made.
#pragma once

#include "models/model.h"

namespace airlight {

Model reference_model();
Model tables_model();
Model preetham1999_model();
Model hosek2012_model();
Model schafhitzel2007_model();
Model bruneton2008_model();
Model elek2009_model();
Model hillaire2020_model();

}  // namespace airlight
