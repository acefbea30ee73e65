// A sky whose light stands in tables by altitude, view and sun, without phase functions: the part before an object is the difference
// of two look-ups. What schafhitzel2007 and elek2009 have in common.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "models/model.h"
#include "sky/pack_phases.h"
#include "transport/ray_light.h"

namespace airlight {

// A place in the air and a direction, with the sun's; `ground`: whether the ray from where it began meets the ground.
struct AirView {
    double altitude_m, mu, mu_s, nu;
    bool ground;
};

// The part of a view that lies in the air, up to a distance from the eye.
struct AirPiece {
    AirView start, end;
    double length_m;
    bool whole;  // it ends where the air ends, or at the ground
};
// None if the view misses the air, or does not reach it within the distance.
std::optional<AirPiece> air_piece(const Shell& shell, const View& view, double distance_m);

// Whether the planet's shadow, a cylinder behind the ground sphere, falls on any of it.
bool shadow_touches(const Shell& shell, const AirPiece& piece);

// Light scattered once along a ray, by each constituent, to be multiplied by its phase function. `prepared` is the same ray.
std::array<f32::IrradianceSpectrum, max_parts> single_light(const PackAir& air, const Table<f32::Spectrum, 2>& transmittance,
                                                            const PreparedRay& prepared, const Ray& ray, int nodes_per_piece);

// Light of the air along a ray to where it leaves the air or meets the ground, as a table has it.
struct AirLight {
    f32::RadianceSpectrum multiple;
    std::array<f32::IrradianceSpectrum, max_parts> single;  // of each constituent
};

class TwoLookUpSky : public PublishedSky {
public:
    struct Pack {
        PackPhases phases;
        PackAir air;
        Table<f32::Spectrum, 2> transmittance;  // of transport, for the sun
        std::vector<f32::Spectrum> depths;      // optical_depths()
        std::function<AirLight(const AirView&)> light;
        std::function<f32::IrradianceSpectrum(double altitude_m, double mu_s)> sky_on_level;
    };
    // `lowest_sun`: the least cosine of the sun's zenith angle that the tables hold.
    TwoLookUpSky(const ModelCard& card, const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, std::vector<Pack> packs,
                 double lowest_sun);

    Result<std::vector<double>> transmittance(Length altitude, double view_zenith, Length distance) const override;
    Result<AerialPerspective> aerial_perspective(const View& view, Length distance) const override;

private:
    std::vector<double> sky_radiance(const View& view) const override;
    // Not if the view enters the air where the sun is lower than the tables hold, or if the planet's shadow touches it.
    Result<Done> answerable(const View& view) const override;
    Result<Done> answerable(const std::optional<AirPiece>& piece) const;
    const Shell& shell() const { return packs_[0].air.shell; }

    std::vector<Pack> packs_;
    double lowest_sun_;
};

}  // namespace airlight
