// dobashi1997 fitted to an atmosphere with all orders of scattering. [Dobashi1997]
// Uses the truth (truth.h), and the series of the model (models/dobashi1997_series.h).
#pragma once

#include "fit/residual.h"
#include "fit/truth.h"
#include "models/dobashi1997_series.h"

namespace airlight {

struct DobashiFit {
    Dobashi1997Data data;
    Residuals residuals;  // at suns of the series and between them, in all directions, between the bands as well
};

Result<DobashiFit> fit_dobashi1997(const Atmosphere& atmosphere, std::span<const Wavelength> wavelengths,
                                   const Dobashi1997Settings& settings, const TruthSettings& truth, Team& team, const JobStore& store,
                                   const Progress& progress);

}  // namespace airlight
