// O'Neil's scale function fitted to the two constituents that oneil2005 takes an atmosphere for. [ONeil2005]
// Uses models (oneil2005_data.h, scale_function_fit.h, two_constituents.h).
#pragma once

#include "atmosphere/atmosphere.h"
#include "fit/residual.h"
#include "models/oneil2005_data.h"

namespace airlight {

struct ONeilFit {
    ONeil2005Data data;
    Residuals residuals;  // of the optical length of either, over all cosines from the zenith to the horizon
};

ONeilFit fit_oneil2005(const Atmosphere& atmosphere);

}  // namespace airlight
