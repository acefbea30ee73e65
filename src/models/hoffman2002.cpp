// hoffman2002: extinction and in-scattering in closed form, for every vertex of a scene. [Hoffman2002]
//
//   computes     single scattering and transmittance over a path in air of constant density: that of the ground, lit everywhere as
//                the eye is: L = L0 e^-(beta s) + beta(angle) / beta E (1 - e^-(beta s)); sun and sky by the same formula
//   leaves out   altitude, light scattered more than once, the ground's light, gases that absorb (ozone)
//   parameters   none
//   converted    the paper leaves the sky's distance to the user: here molecules and aerosol end at one scale height each, above a
//                round ground, where a layer of constant density holds as much as the exponential; any atmosphere
//                (two_constituents.h)
//   cost         two exponentials a wavelength
//   reference    the text is physics/models/constant_air.glsl (even_light)
#include "models/exponential_sky.h"
#include "models/list.h"

namespace airlight {

namespace {

constexpr ModelCard card{.key = "hoffman2002",
                         .paper = "Hoffman2002",
                         .scattering = "single",
                         .approach = "closed form in air of constant density",
                         .precomputation = "none",
                         .memory = "none",
                         .highest_eye = 0.0 * m,
                         .highest_sun_zenith_deg = 90.0,
                         .highest_view_zenith_deg = 90.0,
                         .aerial_perspective = true};

class Hoffman2002 : public ExponentialSky {
public:
    Hoffman2002(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths)
        : ExponentialSky(card, atmosphere, std::move(wavelengths)) {}

private:
    // What a ray from the ground meets of both constituents, if they end at their scale heights.
    f64::AirColumns columns(std::size_t i, f64::Number mu, f64::Length length) const {
        const f64::ExponentialAir& air = pack(i).air;
        const f64::Length ground = 0.0 * f64::m;
        return {min(length, f64::distance_to_top(ground, max(mu, f64::Number(0.0)), air.bottom, air.air_scale_height)),
                min(length, f64::distance_to_top(ground, max(mu, f64::Number(0.0)), air.bottom, air.aerosol_scale_height))};
    }

    f64::ScatteredLight light(std::size_t i, const f64::AirRay& ray) const override {
        const f64::ExponentialAir& air = pack(i).air;
        f64::Spectrum sun(f64::Number(0.0));
        if (ray.mu_s >= 0.0) sun = exp(-f64::optical_depth(air, columns(i, ray.mu_s, f64::Length::of(1e300))));
        return f64::even_light(air, columns(i, ray.mu, ray.reach), sun);
    }
};

Result<std::unique_ptr<Sky>> make(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions&) {
    return std::unique_ptr<Sky>(std::make_unique<Hoffman2002>(atmosphere, std::move(wavelengths)));
}

}  // namespace

Model hoffman2002_model() { return {card, make}; }

}  // namespace airlight
