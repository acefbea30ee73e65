// klassen1987: two curved shells of constant density, and a thin layer of fog. [Klassen1987]
//
//   computes     single scattering in the lower shell, of molecules and haze; both shells attenuate; transmittance and aerial
//                perspective; the ground, Lambertian, lit by the sun alone
//   leaves out   light scattered in the upper shell (the paper takes it for unlikely: most of a clear sky's blue is missing) or more
//                than once, skylight on the ground, gases that absorb (ozone)
//   parameters   32 samples along the view; variant: clear, or fog: a layer of 50 m on the ground through which one sees 200 m
//                (contrast 0.02), white, lit by the sun that comes through the shells above
//   converted    any atmosphere, to two exponential constituents (two_constituents.h), and each of these to a shell of the same
//                column and mean altitude: haze of half its density up to two scale heights; molecules below that as many as there
//                are, above that half as dense as at its edge, for two of their scale heights
//   cost         32 samples, each with the sun's path in closed form
//   reference    the text is physics/models/klassen1987.glsl
#include <cmath>

#include "models/exponential_sky.h"
#include "models/list.h"

namespace airlight {

namespace {

constexpr int samples = 32;
const f64::Length fog_top = f64::Length::of(50.0);
const f64::Length fog_visibility = f64::Length::of(200.0);

constexpr ModelCard card{.key = "klassen1987",
                         .paper = "Klassen1987",
                         .scattering = "single, below the haze's edge",
                         .approach = "two shells of constant density, marched in the lower",
                         .precomputation = "none",
                         .memory = "none",
                         .highest_eye = anywhere,
                         .aerial_perspective = true};

f64::KlassenLayers layers_of(const f64::ExponentialAir& air) {
    const double haze_top = std::min(2.0 * air.aerosol_scale_height.value, 0.5 * air.top.value);
    const double h = air.air_scale_height.value;
    const double air_top = std::min(haze_top + 2.0 * h, air.top.value);
    const double below = h * -std::expm1(-haze_top / h), above = h * (std::exp(-haze_top / h) - std::exp(-air.top.value / h));
    const double aerosol = air.aerosol_scale_height.value * -std::expm1(-air.top.value / air.aerosol_scale_height.value);
    const auto length = [](double metres) { return f64::Length::of(metres); };
    return f64::klassen1987_layers(length(haze_top), length(air_top), below / haze_top, aerosol / haze_top, above / (air_top - haze_top));
}

class Klassen1987 : public ExponentialSky {
public:
    Klassen1987(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, bool fog)
        : ExponentialSky(card, atmosphere, std::move(wavelengths)), layers_(layers_of(pack(0).air)), fog_(fog) {}

private:
    f64::ScatteredLight light(std::size_t i, const f64::AirRay& ray) const override {
        f64::ScatteredLight seen = f64::klassen1987_light(pack(i).air, layers_, below_the_top(i, ray), samples);
        if (!fog_) return seen;
        // What lies beyond the fog comes through it. Fog surrounds the near end of the ray or the far one.
        const f64::Number through = fog_through(i, ray);
        if (ray.altitude < fog_top) {
            seen.air = seen.air * through;
            seen.aerosol = seen.aerosol * through;
        }
        seen.depth += f64::Spectrum(-log(max(through, f64::Number(1e-304))));
        return seen;
    }

    f64::PhaseSpectrum more_light(std::size_t i, const f64::AirRay& ray) const override {
        if (!fog_) return ExponentialSky::more_light(i, ray);
        const f64::AirRay inside = below_the_top(i, ray);
        f64::Spectrum before(f64::Number(1.0));
        if (ray.altitude >= fog_top) {
            const f64::ShellPath path = f64::path_in_shell(ray.altitude, ray.mu, pack(i).air.bottom, fog_top, ray.reach);
            f64::AirRay clear = inside;
            clear.reach = path.start;
            before = exp(-f64::klassen1987_light(pack(i).air, layers_, clear, samples).depth);
        }
        const f64::Spectrum sun = f64::klassen1987_sunlight(pack(i).air, layers_, 0.0 * f64::m, ray.mu_s);
        return before * sun * ((1.0 - fog_through(i, ray)) * 0.25 / f64::pi * f64::per_sr);
    }

    f64::Number fog_through(std::size_t i, const f64::AirRay& ray) const {
        const f64::ShellPath path = f64::path_in_shell(ray.altitude, ray.mu, pack(i).air.bottom, fog_top, ray.reach);
        return f64::exponential_fog(-std::log(0.02) / fog_visibility, path.within);
    }

    // The upper shell ends below the atmosphere's top: a ray from above it starts at its edge, one that leaves it ends there.
    f64::AirRay below_the_top(std::size_t i, f64::AirRay ray) const {
        const f64::ExponentialAir& air = pack(i).air;
        const f64::ShellPath path = f64::path_in_shell(ray.altitude, ray.mu, air.bottom, layers_.air_top, ray.reach);
        if (ray.altitude > layers_.air_top && path.within > 0.0 * f64::m) {
            const f64::Length start = layers_.air_top;
            const f64::Number mu = f64::cosine_at(ray.altitude, ray.mu, path.start, start, air.bottom);
            ray.mu_s = f64::sun_cosine_at(ray.altitude, ray.mu_s, ray.nu, path.start, start, air.bottom);
            ray.mu = mu;
            ray.altitude = start;
        }
        ray.reach = path.within;
        return ray;
    }

    f64::KlassenLayers layers_;
    bool fog_;
};

Result<std::unique_ptr<Sky>> make(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions& options) {
    const Result<std::string> variant = variant_of(card, options, {"clear", "fog"});
    if (!variant) return variant.error();
    return std::unique_ptr<Sky>(std::make_unique<Klassen1987>(atmosphere, std::move(wavelengths), *variant == "fog"));
}

}  // namespace

Model klassen1987_model() { return {card, make}; }

}  // namespace airlight
