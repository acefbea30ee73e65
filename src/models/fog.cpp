// fog: range fog, the baseline that every graphics library had. [Klassen1987, sec. 5; Hoffman2002, sec. 1]
//
//   computes     what of an object's light comes through at a distance, and the fog's colour in its stead; the sky is fog
//   leaves out   altitude, the direction of the sun, the colour of the sky
//   parameters   variant: exponential (e^-(extinction distance)) or linear (clear at the eye, nothing beyond the last distance)
//   converted    extinction is the atmosphere's at the ground, by wavelength; linear fog ends at twice the mean free path, where
//                both forms let the same light through in the mean over distances; the colour is that of endless fog that scatters
//                the sun's light at the ground once, the same to all sides; any atmosphere (two_constituents.h)
//   cost         an exponential a wavelength
//   reference    the text is physics/models/constant_air.glsl
#include <algorithm>
#include <cmath>

#include "models/exponential_sky.h"
#include "models/list.h"

namespace airlight {

namespace {

constexpr ModelCard card{.key = "fog",
                         .paper = "Klassen1987",
                         .scattering = "none; a colour",
                         .approach = "exponential or linear in the distance",
                         .precomputation = "none",
                         .memory = "none",
                         .highest_eye = 0.0 * m,
                         .highest_sun_zenith_deg = 90.0,
                         .highest_view_zenith_deg = 90.0,
                         .aerial_perspective = true};

class Fog : public ExponentialSky {
public:
    Fog(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, bool linear)
        : ExponentialSky(card, atmosphere, std::move(wavelengths)), linear_(linear) {}

private:
    // A sky's ray has no object at its end: there is fog for ever.
    bool endless(std::size_t i, const f64::AirRay& ray) const {
        return ray.reach >= f64::distance_in_air(pack(i).air, ray.altitude, ray.mu);
    }

    f64::Spectrum transmittance_of(std::size_t i, f64::Length distance) const {
        const f64::ScatteringSpectrum extinction = pack(i).air.air_extinction + pack(i).air.aerosol_extinction;
        f64::Spectrum through;
        for (int w = 0; w < pack_size; ++w)
            through.set(
                w, linear_ ? f64::linear_fog(0.0 * f64::m, 2.0 / extinction[w], distance) : f64::exponential_fog(extinction[w], distance));
        return through;
    }

    // Depths of what the form lets through; 700 stands for nothing.
    f64::ScatteredLight light(std::size_t i, const f64::AirRay& ray) const override {
        f64::ScatteredLight fog = f64::no_scattered_light();
        const f64::Spectrum through = transmittance_of(i, ray.reach);
        for (int w = 0; w < pack_size; ++w) fog.depth.v[w] = -std::log(std::max(through.v[w], 1e-304));
        return fog;
    }

    f64::PhaseSpectrum more_light(std::size_t i, const f64::AirRay& ray) const override {
        f64::Spectrum opaque = f64::Spectrum(f64::Number(1.0));
        if (!endless(i, ray)) opaque = opaque - transmittance_of(i, ray.reach);
        const f64::Spectrum albedo = (pack(i).air_scattering + pack(i).aerosol_scattering) /
                                     max(pack(i).air.air_extinction + pack(i).air.aerosol_extinction,
                                         f64::ScatteringSpectrum(f64::ScatteringSpectrum::Scalar::of(1e-300)));
        return opaque * albedo * sun_at_ground(i, ray.mu_s) * (0.25 / f64::pi * f64::per_sr);
    }

    // Through the real air: fog itself is what the sun has above it.
    f64::Spectrum sun_at_ground(std::size_t i, f64::Number mu_s) const {
        return f64::kaneda1991_sunlight(pack(i).air, 0.0 * f64::m, mu_s, 32);
    }

    bool linear_;
};

Result<std::unique_ptr<Sky>> make(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions& options) {
    const Result<std::string> variant = variant_of(card, options, {"exponential", "linear"});
    if (!variant) return variant.error();
    return std::unique_ptr<Sky>(std::make_unique<Fog>(atmosphere, std::move(wavelengths), *variant == "linear"));
}

}  // namespace

Model fog_model() { return {card, make}; }

}  // namespace airlight
