// Every model, one function a file: each tells its card and how it is made.
#pragma once

#include "models/model.h"

namespace airlight {

Model reference_model();
Model tables_model();
Model fog_model();
Model klassen1987_model();
Model kaneda1991_model();
Model nishita1993_model();
Model perez1993_model();
Model nishita1996_model();
Model dobashi1997_model();
Model preetham1999_model();
Model dobashi2002_model();
Model hoffman2002_model();
Model cie2003_model();
Model nielsen2003_model();
Model oneil2004_model();
Model oneil2005_model();
Model hipiny2006_model();
Model schafhitzel2007_model();
Model bruneton2008_model();
Model elek2009_model();
Model hosek2012_model();
Model hillaire2020_model();
Model prague2021_model();
Model airlight_model();

}  // namespace airlight
