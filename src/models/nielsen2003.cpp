// nielsen2003: Hoffman's closed form with an average density for each path, for a flight simulator. [Nielsen2003, ch. 5, 6]
//
//   computes     sky by the closed form, with columns between the exact one of the zenith and one of the horizon that is the same at
//                every altitude; aerial perspective with the density averaged over the path; Rayleigh's phase function softened;
//                asymmetry of the haze and sunlight by the amount of haze, altitude and sun
//   leaves out   the planet's curvature, light scattered more than once, the ground's light, the sky below the horizontal, gases that
//                absorb (ozone)
//   parameters   variant: altitude (density at the mean altitude of the path; the thesis finds it better) or ends (mean of the
//                densities at its ends). Eyes to 30 km
//   converted    any atmosphere, to two exponential constituents (two_constituents.h), whose scale heights stand for 10 km in eq. 5.10.
//                The thesis has no unit of light: sunlight at the eye is the atmosphere's own through the columns of the sun's
//                direction. Haze is from none at turbidity 1 to most at 10, for its own scale of multipliers from 0.0005 to 0.007; its
//                law for sunlight, 9.2 - 550 x that, falls by 0.61 from none to most, and by that share here. Asymmetry with least
//                haze is 0.25 + 1.3e-5 h - 9.2e-6 h s (m, radians); the law for most haze is not legible in the copy at hand: there
//                0.25 everywhere, which is the direction in which the thesis argues (haze scatters more than once, and evens out)
//   cost         three exponentials a wavelength
//   reference    the text is physics/models/nielsen2003.glsl and constant_air.glsl
#include <algorithm>
#include <cmath>

#include "models/exponential_sky.h"
#include "models/list.h"
#include "models/turbidity.h"

namespace airlight {

namespace {

constexpr double highest_m = 30'000.0;

constexpr ModelCard card{.key = "nielsen2003",
                         .paper = "Nielsen2003",
                         .scattering = "single",
                         .approach = "closed form with an average density for each path",
                         .precomputation = "none",
                         .memory = "none",
                         .highest_eye = highest_m * m,
                         .highest_sun_zenith_deg = 90.0,
                         .highest_view_zenith_deg = 180.0,
                         .aerial_perspective = true,
                         .refused = "the sky below the horizontal"};

class Nielsen2003 : public ExponentialSky {
public:
    Nielsen2003(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, bool by_ends, double haze)
        : ExponentialSky(card, atmosphere, std::move(wavelengths)), by_ends_(by_ends), haze_(haze) {}

private:
    // A ray that reaches the top is the sky's; another ends at an object or on the ground.
    f64::AirColumns columns(std::size_t i, const f64::AirRay& ray) const {
        const f64::ExponentialAir& air = pack(i).air;
        if (!f64::meets_ground(ray.altitude, ray.mu, air.bottom) &&
            ray.reach >= f64::distance_to_top(ray.altitude, ray.mu, air.bottom, air.top))
            return f64::nielsen2003_sky_columns(air, ray.altitude, ray.mu);
        const f64::Length end = f64::altitude_at(ray.altitude, ray.mu, ray.reach, air.bottom);
        return by_ends_ ? f64::nielsen2003_by_ends(air, ray.altitude, end, ray.reach)
                        : f64::nielsen2003_by_altitude(air, ray.altitude, end, ray.reach);
    }

    f64::ScatteredLight light(std::size_t i, const f64::AirRay& ray) const override {
        const f64::ExponentialAir& air = pack(i).air;
        f64::Spectrum sun(f64::Number(0.0));
        if (ray.mu_s >= 0.0)
            sun =
                exp(-f64::optical_depth(air, f64::nielsen2003_sky_columns(air, ray.altitude, ray.mu_s))) * f64::Number(1.0 - 0.39 * haze_);
        return f64::even_light(air, columns(i, ray), sun);
    }

    Result<Done> answerable(const View& view) const override {
        const f64::Length h = f64::Length::of(view.altitude.value), bottom = f64::Length::of(bottom_radius().value);
        if (view.view_zenith <= 0.5 * pi || f64::meets_ground(h, std::cos(view.view_zenith), bottom)) return Done{};
        return Error{name(), "does not answer the sky below the horizontal: its dome ends there", "Look up, or at the ground."};
    }

    f64::PhaseSpectrum air_phase(std::size_t, const f64::AirRay& ray) const override {
        return f64::PhaseSpectrum(f64::softened_rayleigh_phase(ray.nu));
    }
    f64::PhaseSpectrum aerosol_phase(std::size_t, const f64::AirRay& ray) const override {
        const double high = 0.25 + 1.3e-5 * highest_m;
        const f64::NielsenCorners clear = f64::nielsen2003_corners(0.25, 0.25, high, high - 9.2e-6 * highest_m * 0.5 * pi);
        const f64::Number h = std::min(ray.altitude.value / highest_m, 1.0);
        const f64::Number sun = std::acos(std::clamp(ray.mu_s.value, 0.0, 1.0)) / (0.5 * pi);
        const f64::Number least = f64::nielsen2003_asymmetry(clear, h, sun);
        return f64::PhaseSpectrum(f64::henyey_greenstein_phase(least + haze_ * (0.25 - least), ray.nu));
    }

    bool by_ends_;
    double haze_;  // 0 to 1
};

Result<std::unique_ptr<Sky>> make(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions& options) {
    const Result<std::string> variant = variant_of(card, options, {"altitude", "ends"});
    if (!variant) return variant.error();
    const Result<double> t = options.turbidity ? Result<double>(*options.turbidity) : turbidity(atmosphere);
    if (!t) return t.error();
    const double haze = std::clamp((*t - 1.0) / 9.0, 0.0, 1.0);
    return std::unique_ptr<Sky>(std::make_unique<Nielsen2003>(atmosphere, std::move(wavelengths), *variant == "ends", haze));
}

}  // namespace

Model nielsen2003_model() { return {card, make}; }

}  // namespace airlight
