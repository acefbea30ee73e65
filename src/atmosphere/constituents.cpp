#include "atmosphere/constituents.h"

#include <cassert>

#include "atmosphere/coefficients.h"
#include "optics/gases.h"
#include "optics/rayleigh.h"

namespace airlight {

namespace {

// Between samples 2 nm apart a law that falls as the fourth power of wavelength is straight to 1e-4 at 300 nm.
template <class Y, class Law>
SpectrumOf<Y> sampled(Law law) {
    std::vector<typename SpectrumOf<Y>::Sample> samples;
    for (int w = 300; w <= 1000; w += 2) samples.push_back({w * nm, law(w * nm)});
    return *SpectrumOf<Y>::of(std::move(samples));
}

}  // namespace

Constituent air_constituent(const DensityProfile& profile, double pressure_hpa) {
    assert(pressure_hpa > 0.0);
    AirColumn column;
    column.pressure_pa = 100.0 * pressure_hpa;
    const Length depth = column_depth(profile, above_all_air);
    const auto scattering = sampled<InverseLength>([&](Wavelength w) { return rayleigh_optical_depth(w, column) / depth; });
    return {"air", profile, scattering, SpectrumOf<InverseLength>::constant(0.0 * per_m),
            RayleighPhase{depolarisation(king_factor_of_air(550.0 * nm))}};
}

Constituent carbon_dioxide_constituent(const DensityProfile& profile, NumberDensity reference) {
    const auto scattering = sampled<InverseLength>([&](Wavelength w) { return rayleigh_cross_section_of_carbon_dioxide(w) * reference; });
    return {"carbon_dioxide", profile, scattering, SpectrumOf<InverseLength>::constant(0.0 * per_m),
            RayleighPhase{depolarisation(king_factor_of_carbon_dioxide(550.0 * nm))}};
}

Constituent absorber_constituent(Gas gas, const DensityProfile& profile, double column_per_m2, double temperature_k) {
    assert(gas == Gas::ozone || gas == Gas::nitrogen_dioxide);
    const SpectrumOf<Area> cross_section =
        gas == Gas::ozone ? ozone_cross_section(temperature_k) : nitrogen_dioxide_cross_section(temperature_k);
    const NumberDensity reference = column_per_m2 / m2 / column_depth(profile, above_all_air);
    std::vector<SpectrumOf<InverseLength>::Sample> samples;
    for (const auto& [wavelength, area] : cross_section.samples()) samples.push_back({wavelength, area * reference});
    Constituent constituent{gas == Gas::ozone ? "ozone" : "nitrogen_dioxide", profile};
    constituent.absorption = *SpectrumOf<InverseLength>::of(std::move(samples));
    return constituent;
}

double column_per_m2(std::span<const AirLevel> levels, Gas gas) {
    const GasProfile of_gas = gas_profile(levels, gas);
    return (of_gas.reference * column_depth(of_gas.profile, above_all_air) * m2).value;
}

MolecularAir molecular_air(const Atmosphere& atmosphere, Wavelength wavelength) {
    MolecularAir air{0.0 * per_m, 0.0};
    for (const Constituent& c : atmosphere.constituents) {
        if (!std::holds_alternative<RayleighPhase>(c.phase)) continue;
        air.scattering_at_ground += relative_density(c.profile, 0.0 * m) * c.scattering.at(wavelength);
        air.optical_depth += optical_depth(c, atmosphere.top_altitude, wavelength).value;
    }
    if (air.optical_depth > 0.0) return air;
    return {rayleigh_cross_section_of_air(wavelength) * standard_number_density, rayleigh_optical_depth(wavelength)};
}

}  // namespace airlight
