// Many directions from the tables of bruneton2008, for one eye and one sun. Internal to the model.
#pragma once

#include <memory>
#include <vector>

#include "models/bruneton2008_tables.h"
#include "models/model.h"
#include "sky/pack_phases.h"

namespace airlight {

// The scattering tables cut at the eye's altitude and the sun: above the horizon a direction is four texels of what is left, in
// vectors over wavelengths. Directions to the ground, fewer and without a cut, are asked of the sky.
class Bruneton2008Dome : public SkyDome {
public:
    using Packs = std::shared_ptr<const std::vector<std::unique_ptr<Bruneton2008Tables>>>;

    // `sky` must outlive it; `altitude` is within the air.
    Bruneton2008Dome(const Sky& sky, Packs packs, Length altitude, double sun_zenith);

    void radiance(double view_zenith, double relative_azimuth, std::span<float> radiance) const override;
    void radiances(std::span<const Direction> directions, std::span<float> radiance) const override;

private:
    struct Pack {
        Bruneton2008Tables::Slice slice;
        PackPhases phases;
    };
    void sky_radiance(float mu, double nu, float* radiance) const;

    const Sky& sky_;
    Packs packs_;
    Length altitude_;
    double sun_zenith_;
    f32::Length h_, bottom_, top_;
    std::vector<Pack> cut_;
};

}  // namespace airlight
