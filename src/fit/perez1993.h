// perez1993 fitted to an atmosphere: radiance, wavelength by wavelength, so that colours follow from the air and not from a law of
// daylight. [Perez1993]
// Uses the truth (truth.h), Perez's form (perez_form.h) and the form of the file (models/perez1993_data.h).
#pragma once

#include "fit/residual.h"
#include "fit/truth.h"
#include "models/perez1993_data.h"

namespace airlight {

struct PerezFit {
    Perez1993Data data;
    Residuals residuals;  // at the suns of the fit and between them, 5 to 90 degrees above the horizon
};

Result<PerezFit> fit_perez1993(const Atmosphere& atmosphere, std::span<const Wavelength> wavelengths, Length altitude,
                               const TruthSettings& truth, Team& team, const JobStore& store, const Progress& progress);

}  // namespace airlight
