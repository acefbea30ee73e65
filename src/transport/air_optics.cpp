#include "transport/air_optics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/quadrature.h"

namespace airlight {

namespace {

// Samples of a tabulated phase function: with them, linear interpolation of a peak of one degree errs by less than 0.1 %.
constexpr int phase_samples = 4096;

// value(w) at each wavelength of the pack.
template <class Value>
auto sampled(std::span<const Wavelength, pack_size> wavelengths, Value value) {
    SpectralOf<decltype(value(wavelengths[0])), pack_size> spectrum;
    for (int i = 0; i < pack_size; ++i) spectrum.set(i, value(wavelengths[static_cast<std::size_t>(i)]));
    return spectrum;
}

double sample_angle(int i) {
    const double u = static_cast<double>(i) / (phase_samples - 1);
    return pi * u * u;
}

}  // namespace

SpectralPhase::SpectralPhase(const PhaseFunction& phase, std::span<const Wavelength, pack_size> wavelengths) : g_(f64::Number(0.0)) {
    if (std::holds_alternative<IsotropicPhase>(phase)) {
        kind_ = Kind::isotropic;
    } else if (const auto* rayleigh = std::get_if<RayleighPhase>(&phase)) {
        kind_ = Kind::rayleigh;
        rayleigh_gamma_ = rayleigh->depolarisation / (2.0 - rayleigh->depolarisation);
    } else if (const auto* hg = std::get_if<HenyeyGreensteinPhase>(&phase)) {
        kind_ = Kind::henyey_greenstein;
        g_ = sampled(wavelengths, [&](Wavelength w) { return hg->g.at(w); });
    } else if (const auto* cs = std::get_if<CornetteShanksPhase>(&phase)) {
        kind_ = Kind::cornette_shanks;
        g_ = sampled(wavelengths, [&](Wavelength w) { return cs->g.at(w); });
    } else {
        kind_ = Kind::tabulated;
        for (int i = 0; i < phase_samples; ++i) {
            const double nu = std::cos(sample_angle(i));
            table_.push_back(sampled(wavelengths, [&](Wavelength w) { return phase_value(phase, nu, w); }));
        }
        // Sampled again, the function must still integrate to one.
        const f64::Spectrum integral = legendre_moments(1)[0];
        for (f64::PhaseSpectrum& row : table_) row = row / integral;
    }
}

f64::PhaseSpectrum SpectralPhase::tabulated_at(double nu) const {
    const double u = std::sqrt(std::acos(std::clamp(nu, -1.0, 1.0)) / pi) * (phase_samples - 1);
    const int i = std::min(static_cast<int>(u), phase_samples - 2);
    const f64::Number t = u - i;
    return table_[static_cast<std::size_t>(i)] * (1.0 - t) + table_[static_cast<std::size_t>(i) + 1] * t;
}

f64::PhaseSpectrum SpectralPhase::at(double nu) const {
    if (kind_ == Kind::tabulated) return tabulated_at(nu);
    if (kind_ == Kind::isotropic) return f64::PhaseSpectrum(1.0 / (4.0 * pi) * f64::per_sr);
    if (kind_ == Kind::rayleigh) return f64::PhaseSpectrum(f64::depolarised_rayleigh_phase(rayleigh_gamma_, nu));
    f64::PhaseSpectrum values;
    if (kind_ == Kind::henyey_greenstein)
        for (int i = 0; i < pack_size; ++i) values.set(i, f64::henyey_greenstein_phase(g_[i], nu));
    else
        for (int i = 0; i < pack_size; ++i) values.set(i, f64::cornette_shanks_phase(g_[i], nu));
    return values;
}

std::vector<f64::Spectrum> SpectralPhase::legendre_moments(int count) const {
    // The scattering angle is pi u^2 with u in [0, 1]: the nodes then crowd where peaks are.
    static const GaussRule rule = gauss_rule(1024, 0.0, 1.0);
    std::vector<f64::Spectrum> moments(static_cast<std::size_t>(count), f64::Spectrum(f64::Number(0.0)));
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
        const double u = rule.nodes[k];
        const double angle = pi * u * u;
        const double nu = std::cos(angle);
        const f64::Number weight = rule.weights[k] * 2.0 * pi * u * 2.0 * pi * std::sin(angle);
        const f64::PhaseSpectrum value = at(nu);
        double p = 1.0, previous = 0.0;
        for (int l = 0; l < count; ++l) {
            moments[static_cast<std::size_t>(l)] += value / f64::per_sr * (weight * p);
            previous = std::exchange(p, ((2 * l + 1) * nu * p - l * previous) / (l + 1));
        }
    }
    return moments;
}

AirOptics air_optics(const Atmosphere& atmosphere, std::span<const Wavelength> wavelengths) {
    assert(!wavelengths.empty() && wavelengths.size() <= pack_size);
    AirOptics optics{.wavelength_count = static_cast<int>(wavelengths.size()),
                     .wavelengths = {},
                     .bottom_radius = f64::Length::of(atmosphere.bottom_radius.value),
                     .top_altitude = f64::Length::of(atmosphere.top_altitude.value),
                     .parts = {},
                     .ground_albedo = f64::Spectrum(f64::Number(0.0)),
                     .solar_irradiance = f64::IrradianceSpectrum(f64::IrradianceSpectrum::Scalar::of(0.0)),
                     .sun = atmosphere.sun};
    for (std::size_t i = 0; i < pack_size; ++i) optics.wavelengths[i] = wavelengths[std::min(i, wavelengths.size() - 1)];
    const std::span<const Wavelength, pack_size> pack(optics.wavelengths);
    for (const Constituent& c : atmosphere.constituents) {
        const f64::ScatteringSpectrum scattering = sampled(pack, [&](Wavelength w) { return c.scattering.at(w); });
        const f64::ScatteringSpectrum absorption = sampled(pack, [&](Wavelength w) { return c.absorption.at(w); });
        const bool scatters = std::any_of(scattering.v, scattering.v + pack_size, [](double x) { return x > 0.0; });
        optics.parts.push_back({c.profile, scattering, scattering + absorption,
                                SpectralPhase(scatters ? c.phase : PhaseFunction(IsotropicPhase{}), pack), scatters});
    }
    optics.ground_albedo = sampled(pack, [&](Wavelength w) { return atmosphere.ground_albedo.at(w); });
    optics.solar_irradiance = sampled(pack, [&](Wavelength w) { return atmosphere.sun.irradiance.at(w); });
    return optics;
}

std::vector<std::vector<Wavelength>> packs(std::span<const Wavelength> wavelengths) {
    std::vector<std::vector<Wavelength>> result;
    for (std::size_t i = 0; i < wavelengths.size(); i += pack_size) {
        const auto pack = wavelengths.subspan(i, std::min<std::size_t>(pack_size, wavelengths.size() - i));
        result.emplace_back(pack.begin(), pack.end());
    }
    return result;
}

}  // namespace airlight
