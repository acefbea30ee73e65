// The turbidity that the models of turbidity take an atmosphere for.
#pragma once

#include "models/model.h"

namespace airlight {

// Vertical optical depth at 550 nm of all that scatters over that of molecules (constituents with Rayleigh's phase function):
// T = (tau_molecules + tau_aerosol) / tau_molecules >= 1. Gases that only absorb are not counted. [Preetham1999]
// Fails if the atmosphere has no molecules that scatter, or no data at 550 nm.
Result<double> turbidity(const Atmosphere& atmosphere);

// The turbidity that the user gave, or else the atmosphere's; fails outside of the model's range.
Result<double> turbidity_in(double lowest, double highest, std::string_view model, const Atmosphere& atmosphere,
                            const ModelOptions& options);

}  // namespace airlight
