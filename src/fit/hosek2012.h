// hosek2012 fitted to an atmosphere: coefficients in the form of the published data set. [HosekWilkie2012]
// Uses the truth (truth.h) and the form (hosek2012_form.h).
#pragma once

#include "fit/hosek2012_form.h"
#include "fit/residual.h"
#include "fit/truth.h"

namespace airlight {

struct HosekFitSettings {
    std::vector<double> turbidities;  // increasing; one or more
    std::vector<double> albedos = {0.0, 1.0};
    std::vector<Wavelength> wavelengths;
    Length altitude = 0.0 * m;  // of the eye
    TruthSettings truth = {};
};

struct HosekFit {
    Hosek2012Data data;   // its numbers have seven digits
    Residuals residuals;  // each turbidity, at the fitted suns and between them, 5 to 90 degrees above the horizon
};

// The air's aerosol is scaled to each turbidity, its ground takes each albedo.
Result<HosekFit> fit_hosek2012(const Atmosphere& atmosphere, const HosekFitSettings& settings, Team& team, const JobStore& store,
                               const Progress& progress);

// The file that the model reads, with lines that say what it is.
std::string hosek_csv(const HosekFit& fit, std::string_view atmosphere);

}  // namespace airlight
