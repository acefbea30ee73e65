// hipiny2006 fitted to an atmosphere: luminance and chromaticity by altitude, turbidity and sun. [Hipiny2006]
// Uses the truth (truth.h), Perez's form (perez_form.h) and the form of the file (models/hipiny2006_data.h).
#pragma once

#include "fit/residual.h"
#include "fit/truth.h"
#include "models/hipiny2006_data.h"

namespace airlight {

struct HipinyFitSettings {
    std::vector<double> altitudes_m;  // increasing, 0 to 30 km
    std::vector<double> turbidities;  // increasing; one or more
    TruthSettings truth = {};
};

struct HipinyFit {
    Hipiny2006Data data;  // its numbers have six digits
    Residuals residuals;  // of luminance and of the chromaticities, at each altitude and all turbidities, suns 5 to 90 degrees high
};

// The colours are those that CIE's observer of 1931 sees at the standard wavelengths. One sky of tables serves all altitudes.
Result<HipinyFit> fit_hipiny2006(const Atmosphere& atmosphere, const HipinyFitSettings& settings, Team& team, const JobStore& store,
                                 const Progress& progress);

}  // namespace airlight
