// An atmosphere as the early models have it: two constituents, molecules and aerosol, whose densities fall exponentially.
// Uses atmosphere and the shared text; knows nothing of rays.
#pragma once

#include <span>
#include <vector>

#include "physics/models/f64.h"
#include "transport/air_optics.h"

namespace airlight {

// Of up to sixteen wavelengths. Constituents with Rayleigh's phase function are air, others that scatter are aerosol, and gases
// that only absorb are left out, for the papers have none. An exponential constituent stays as it is; of other profiles the
// column and the mean altitude are kept, and several constituents of one kind become one.
struct TwoConstituents {
    f64::ExponentialAir air;
    f64::ScatteringSpectrum air_scattering;  // at the ground
    f64::ScatteringSpectrum aerosol_scattering;
    AirOptics optics;
    std::vector<f64::Spectrum> air_shares;  // [parts] of the molecules' scattering; zeros for what is none
    std::vector<f64::Spectrum> aerosol_shares;

    // The mean phase functions of either kind, by what each constituent scatters.
    f64::PhaseSpectrum air_phase(double nu) const { return mean_phase(air_shares, nu); }
    f64::PhaseSpectrum aerosol_phase(double nu) const { return mean_phase(aerosol_shares, nu); }

private:
    f64::PhaseSpectrum mean_phase(const std::vector<f64::Spectrum>& shares, double nu) const;
};

TwoConstituents two_constituents(const Atmosphere& atmosphere, std::span<const Wavelength> wavelengths);

}  // namespace airlight
