// The skies that a fit is made to: radiances of the reference or of the tables, computed in jobs.
// Uses models (who answers), jobs and the description.
#pragma once

#include <vector>

#include "fit/team.h"
#include "models/model.h"

namespace airlight {

enum class Truth { tables, reference };

struct TruthSettings {
    Truth truth = Truth::tables;
    BakeSettings bake = {};            // of the tables
    ReferenceSettings reference = {};  // of the Monte Carlo
};

// Views of one atmosphere.
struct TrueSky {
    Atmosphere atmosphere;
    std::vector<View> views;
};

// Radiances of every view of every sky: [sky][view * N + wavelength], W m-2 sr-1 nm-1. Tables are one job a sky, the reference
// one job for each sun of a sky (views of one sun follow each other).
Result<std::vector<std::vector<double>>> true_radiances(std::span<const TrueSky> skies, std::span<const Wavelength> wavelengths,
                                                        const TruthSettings& settings, Team& team, const JobStore& store,
                                                        const Progress& progress);

// The same air with its aerosol (all that scatters but by Rayleigh's law) scaled so that turbidity() is `turbidity`.
// Fails below 1, or above 1 where there is no aerosol.
Result<Atmosphere> with_turbidity(Atmosphere atmosphere, double turbidity);

// Directions of the upper hemisphere that stand for equal solid angles each, and a few close to the sun and at the horizon.
struct FitDirection {
    Direction direction;
    double weight;  // 1 for those of equal solid angle, less for the others
};
std::vector<FitDirection> fit_directions(double sun_zenith, int rings, int azimuths);

}  // namespace airlight
