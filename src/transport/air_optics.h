// An atmosphere at up to sixteen wavelengths, in the form in which inner loops read it.
// Derived from the description and never changed. Uses atmosphere and the f64 reading of the physics.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "atmosphere/atmosphere.h"
#include "physics/f64.h"

namespace airlight {

// Wavelengths are worked on in packs of sixteen; a last pack that is not full repeats its last wavelength.
inline constexpr int pack_size = f64::N;

// A phase function at the wavelengths of a pack.
class SpectralPhase {
public:
    SpectralPhase(const PhaseFunction& phase, std::span<const Wavelength, pack_size> wavelengths);

    bool is_rayleigh() const { return kind_ == Kind::rayleigh; }

    // Its values at the cosine `nu` of the scattering angle, -1 <= nu <= 1.
    f64::PhaseSpectrum at(double nu) const;

    // The moments chi_l of its Legendre series, phase = sum over l of (2 l + 1) chi_l P_l(nu) / (4 pi), for l < count: [count].
    std::vector<f64::Spectrum> legendre_moments(int count) const;

private:
    enum class Kind { isotropic, rayleigh, henyey_greenstein, cornette_shanks, tabulated };
    f64::PhaseSpectrum tabulated_at(double nu) const;

    Kind kind_;
    double rayleigh_gamma_ = 0.0;
    f64::Spectrum g_;
    std::vector<f64::PhaseSpectrum> table_;  // [samples], even in the root of the scattering angle, so dense near forward
};

struct AirOptics {
    struct Part {
        DensityProfile profile;
        f64::ScatteringSpectrum scattering;  // where the profile is 1
        f64::ScatteringSpectrum extinction;
        SpectralPhase phase;
        bool scatters;
    };

    int wavelength_count;  // 1 to 16: how many of the pack are distinct
    std::array<Wavelength, pack_size> wavelengths;
    f64::Length bottom_radius;
    f64::Length top_altitude;
    std::vector<Part> parts;
    f64::Spectrum ground_albedo;
    f64::IrradianceSpectrum solar_irradiance;
    Sun sun;
};

// `wavelengths`: 1 to 16, increasing, each covered by the atmosphere (asserted).
AirOptics air_optics(const Atmosphere& atmosphere, std::span<const Wavelength> wavelengths);

// The wavelengths of a grid in packs of at most sixteen, in order.
std::vector<std::vector<Wavelength>> packs(std::span<const Wavelength> wavelengths);

}  // namespace airlight
