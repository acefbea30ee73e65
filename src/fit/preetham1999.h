// preetham1999 fitted to an atmosphere: luminance and chromaticity by coefficients linear in turbidity, as in the paper; of one turbidity
// they are constants. [Preetham1999]
// Uses the truth (truth.h), least squares and the form of the file (models/preetham1999_data.h).
#pragma once

#include "fit/residual.h"
#include "fit/truth.h"
#include "models/preetham1999_data.h"

namespace airlight {

struct PreethamFitSettings {
    std::vector<double> turbidities;  // increasing; one or more
    Length altitude = 0.0 * m;        // of the eye
    TruthSettings truth = {};
};

struct PreethamFit {
    Preetham1999Data data;
    Residuals residuals;  // each turbidity and quantity, at the suns of the fit and between them, 5 to 90 degrees high
};

Result<PreethamFit> fit_preetham1999(const Atmosphere& atmosphere, const PreethamFitSettings& settings, Team& team, const JobStore& store,
                                     const Progress& progress);

}  // namespace airlight
