#include "models/exponential_sky.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "transport/ray_nodes.h"

namespace airlight {

ExponentialSky::ExponentialSky(const ModelCard& card, const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths)
    : PublishedSky(card, atmosphere, std::move(wavelengths)) {
    for (const std::vector<Wavelength>& pack : packs(this->wavelengths())) packs_.push_back(two_constituents(atmosphere, pack));
}

std::optional<f64::AirRay> air_ray_of(const TwoConstituents& air, const View& view, double distance_m) {
    const Shell shell{air.air.bottom.value, air.air.top.value};
    const double r = shell.bottom_m + view.altitude.value, mu = std::cos(view.view_zenith);
    Ray ray{view.altitude.value, mu, std::cos(view.sun_zenith), view_sun_cosine(view), distance_m};
    if (!enter_air(shell, ray)) return std::nullopt;
    if (view.altitude.value > shell.top_m) ray.limit_m -= -r * mu + (shell.bottom_m + shell.top_m) * ray.mu;
    const f64::Length altitude = f64::Length::of(ray.altitude_m);
    const double length = std::min(ray.limit_m, f64::distance_in_air(air.air, altitude, ray.mu).value);
    if (!(length > 0.0)) {
        // On the ground, looking down: no air, but the ground.
        if (view.altitude.value > 0.0 || mu >= 0.0) return std::nullopt;
        return f64::air_ray(altitude, ray.mu, ray.mu_s, ray.nu, 0.0 * f64::m);
    }
    return f64::air_ray(altitude, ray.mu, ray.mu_s, ray.nu, f64::Length::of(length));
}

bool ends_on_ground(const TwoConstituents& air, const f64::AirRay& ray) {
    return f64::meets_ground(ray.altitude, ray.mu, air.air.bottom) &&
           ray.reach >= f64::distance_to_ground(ray.altitude, ray.mu, air.air.bottom);
}

f64::Spectrum ExponentialSky::sunlight(std::size_t i, f64::Length altitude, double mu_s) const {
    const f64::ExponentialAir& air = packs_[i].air;
    if (f64::meets_ground(altitude, mu_s, air.bottom)) return f64::Spectrum(f64::Number(0.0));
    const f64::Length length = f64::distance_to_top(altitude, mu_s, air.bottom, air.top);
    return exp(-light(i, f64::air_ray(altitude, mu_s, mu_s, 1.0, length)).depth);
}

f64::PhaseSpectrum ExponentialSky::more_light(std::size_t, const f64::AirRay&) const { return f64::PhaseSpectrum(0.0 * f64::per_sr); }
f64::PhaseSpectrum ExponentialSky::air_phase(std::size_t i, const f64::AirRay& ray) const { return packs_[i].air_phase(ray.nu.value); }
f64::PhaseSpectrum ExponentialSky::aerosol_phase(std::size_t i, const f64::AirRay& ray) const {
    return packs_[i].aerosol_phase(ray.nu.value);
}

f64::PhaseSpectrum ExponentialSky::ground_light(std::size_t i, const f64::AirRay& ground) const {
    const double cosine = std::max(ground.mu_s.value, 0.0);
    return packs_[i].optics.ground_albedo * sunlight(i, 0.0 * f64::m, ground.mu_s.value) * (cosine / f64::pi * f64::per_sr);
}

f64::PhaseSpectrum ExponentialSky::scattered(std::size_t i, const f64::AirRay& ray, const f64::ScatteredLight& light) const {
    return light.air * packs_[i].air_scattering * air_phase(i, ray) + light.aerosol * packs_[i].aerosol_scattering * aerosol_phase(i, ray) +
           more_light(i, ray);
}

std::vector<double> ExponentialSky::sky_radiance(const View& view) const {
    std::vector<double> radiance;
    for (std::size_t i = 0; i < packs_.size(); ++i) {
        f64::PhaseSpectrum seen(0.0 * f64::per_sr);
        if (const std::optional<f64::AirRay> ray = air_ray_of(packs_[i], view)) {
            const f64::ScatteredLight along = light(i, *ray);
            seen = scattered(i, *ray, along);
            if (ends_on_ground(packs_[i], *ray)) {
                const f64::Length bottom = packs_[i].air.bottom, zero = 0.0 * f64::m;
                const f64::Number mu = f64::cosine_at(ray->altitude, ray->mu, ray->reach, zero, bottom);
                const f64::Number mu_s = f64::sun_cosine_at(ray->altitude, ray->mu_s, ray->nu, ray->reach, zero, bottom);
                seen += exp(-along.depth) * ground_light(i, f64::air_ray(zero, -mu, mu_s, -ray->nu, ray->reach));
            }
        }
        const f64::RadianceSpectrum value = seen * packs_[i].optics.solar_irradiance;
        radiance.insert(radiance.end(), value.v, value.v + packs_[i].optics.wavelength_count);
    }
    return radiance;
}

Result<std::vector<double>> ExponentialSky::transmittance(Length altitude, double view_zenith, Length distance) const {
    if (const Result<Done> ok = within_range({altitude, view_zenith, 0.0, 0.0}); !ok) return ok.error();
    std::vector<double> transmittance;
    for (std::size_t i = 0; i < packs_.size(); ++i) {
        f64::Spectrum through(f64::Number(1.0));
        if (const auto ray = air_ray_of(packs_[i], {altitude, view_zenith, view_zenith, 0.0}, distance.value))
            through = exp(-light(i, *ray).depth);
        transmittance.insert(transmittance.end(), through.v, through.v + packs_[i].optics.wavelength_count);
    }
    return transmittance;
}

Result<AerialPerspective> ExponentialSky::aerial_perspective(const View& view, Length distance) const {
    if (const Result<Done> ok = within_range(view); !ok) return ok.error();
    AerialPerspective perspective;
    for (std::size_t i = 0; i < packs_.size(); ++i) {
        f64::Spectrum through(f64::Number(1.0));
        f64::RadianceSpectrum added(f64::RadianceSpectrum::Scalar::of(0.0));
        if (const auto ray = air_ray_of(packs_[i], view, distance.value)) {
            const f64::ScatteredLight along = light(i, *ray);
            through = exp(-along.depth);
            added = scattered(i, *ray, along) * packs_[i].optics.solar_irradiance;
        }
        const int count = packs_[i].optics.wavelength_count;
        perspective.transmittance.insert(perspective.transmittance.end(), through.v, through.v + count);
        perspective.inscattered_W_m2_sr_nm.insert(perspective.inscattered_W_m2_sr_nm.end(), added.v, added.v + count);
    }
    return perspective;
}

Result<std::string> variant_of(const ModelCard& card, const ModelOptions& options, std::initializer_list<std::string_view> known) {
    if (options.variant.empty()) return std::string(*known.begin());
    if (std::find(known.begin(), known.end(), options.variant) != known.end()) return options.variant;
    return Error{std::string(card.key), fmt::format("has no variant \"{}\"", options.variant),
                 fmt::format("Its variants are: {}.", fmt::join(known, ", "))};
}

}  // namespace airlight
