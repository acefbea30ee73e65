// Nishita's voxels: light that was scattered in the air or by the ground, from eight directions at each altitude and sun.
// [NishitaEtAl1996]
#pragma once

#include <vector>

#include "models/density_spheres.h"

namespace airlight {

// The planet and its sun are round: voxels along one direction from the planet, for each zenith angle of the sun, stand for all.
class LightVoxels {
public:
    static constexpr int altitudes = 24;
    static constexpr int suns = 48;
    static constexpr int directions = 8;

    // Light scattered `orders` times in all, the last time not in a voxel but towards the eye: orders - 1 passes.
    LightVoxels(const TwoConstituents& air, const DensitySpheres& spheres, int orders);

    // Light of the voxels that is scattered into a ray, per unit of the sun's irradiance.
    f64::PhaseSpectrum light(const f64::AirRay& ray) const;

    // Of the voxels that falls on the level ground, per unit of the sun's irradiance, over pi.
    f64::PhaseSpectrum on_ground(double mu_s) const;

private:
    using Voxels = std::vector<f64::PhaseSpectrum>;  // [directions][suns][altitudes]

    f64::SampledPhases phases(double mu, double mu_s, double nu) const;
    f64::PhaseSpectrum light_of(const Voxels& voxels, const f64::SampledPhases& phases, const f64::AirRay& ray) const;
    f64::PhaseSpectrum ground_light_of(const Voxels& voxels, double mu_s) const;
    f64::PhaseSpectrum first_light(const DensitySpheres& spheres, const f64::AirRay& ray, const f64::SampledPhases& from_sun, double region,
                                   int direction) const;

    const TwoConstituents& air_;  // of the model that holds both
    Voxels voxels_;
};

}  // namespace airlight
