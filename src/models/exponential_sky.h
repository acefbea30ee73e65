// What the models of air and aerosol share: the ray that a view is, and how the light along it becomes radiance, transmittance
// and aerial perspective. The arithmetic along rays is physics/models/*.glsl.
#pragma once

#include <initializer_list>
#include <optional>

#include "models/model.h"
#include "models/two_constituents.h"

namespace airlight {

// A model adds light(); the rest it may replace.
class ExponentialSky : public PublishedSky {
public:
    Result<std::vector<double>> transmittance(Length altitude, double view_zenith, Length distance) const override;
    Result<AerialPerspective> aerial_perspective(const View& view, Length distance) const override;

protected:
    ExponentialSky(const ModelCard& card, const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths);

    // Light scattered once along a ray within the air, and the optical depth of the ray. A ray that does not end at the ground
    // or the top ends at an object.
    virtual f64::ScatteredLight light(std::size_t pack, const f64::AirRay& ray) const = 0;

    // What else is scattered into the ray, per unit of the sun's irradiance: nothing but in models of several orders.
    virtual f64::PhaseSpectrum more_light(std::size_t pack, const f64::AirRay& ray) const;

    // The phase functions towards a ray.
    virtual f64::PhaseSpectrum air_phase(std::size_t pack, const f64::AirRay& ray) const;
    virtual f64::PhaseSpectrum aerosol_phase(std::size_t pack, const f64::AirRay& ray) const;

    // Radiance of the ground where a ray meets it, per unit of the sun's irradiance. `ground` is the ray reversed: from there to the
    // eye. By default Lambertian, lit by the sun alone.
    virtual f64::PhaseSpectrum ground_light(std::size_t pack, const f64::AirRay& ground) const;

    std::vector<double> sky_radiance(const View& view) const override;

    const TwoConstituents& pack(std::size_t i) const { return packs_[i]; }
    std::size_t pack_count() const { return packs_.size(); }

    // What comes through from the sun to a place, by the model itself; nothing where the ground stands before it.
    f64::Spectrum sunlight(std::size_t pack, f64::Length altitude, double mu_s) const;

private:
    f64::PhaseSpectrum scattered(std::size_t pack, const f64::AirRay& ray, const f64::ScatteredLight& light) const;

    std::vector<TwoConstituents> packs_;
};

// The ray of a view from where it enters the air, over a distance from the eye; none if it holds no air.
std::optional<f64::AirRay> air_ray_of(const TwoConstituents& air, const View& view, double distance_m = 1e300);

// Whether a ray ends on the ground.
bool ends_on_ground(const TwoConstituents& air, const f64::AirRay& ray);

// The form of a model that the user named, or the first; fails if he named one that the model has not.
Result<std::string> variant_of(const ModelCard& card, const ModelOptions& options, std::initializer_list<std::string_view> known);

}  // namespace airlight
