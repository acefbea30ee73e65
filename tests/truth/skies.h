// The atmospheres whose light the independent figures give, as descriptions.
#pragma once

#include "atmosphere/atmosphere.h"
#include "figures.h"

namespace airlight::truth {

template <class Y>
SpectrumOf<Y> spectrum(std::vector<double> wavelengths_nm, std::vector<Y> values) {
    std::vector<typename SpectrumOf<Y>::Sample> samples;
    for (std::size_t i = 0; i < values.size(); ++i) samples.push_back({wavelengths_nm[i] * nm, values[i]});
    return *SpectrumOf<Y>::of(samples);
}

// The three skies of plane_parallel.csv and spherical.csv as three wavelengths of one description.
inline const std::vector<std::string> sky_names = {"sky_450nm_clear", "sky_550nm_clear", "sky_650nm_hazy"};
inline const std::vector<double> sky_wavelengths_nm = {450.0, 550.0, 650.0};

inline Atmosphere sky(Length radius) {
    const Length top = 100.0 * km;
    const DensityProfile air = ExponentialProfile{8.0 * km};
    const DensityProfile aerosol = ExponentialProfile{1.2 * km};
    const DensityProfile absorber = TriangleProfile{10.0 * km, 25.0 * km, 40.0 * km};
    // Vertical optical depths over column depths.
    const auto coefficient = [&](const DensityProfile& profile, std::vector<double> depths) {
        std::vector<InverseLength> values;
        for (const double d : depths) values.push_back(d / column_depth(profile, top));
        return spectrum(sky_wavelengths_nm, values);
    };
    Atmosphere a;
    a.name = "three skies";
    a.bottom_radius = radius;
    a.top_altitude = top;
    a.constituents.push_back(
        {.name = "air", .profile = air, .scattering = coefficient(air, {0.2184, 0.0973, 0.0494}), .phase = RayleighPhase{}});
    a.constituents.push_back({.name = "aerosol",
                              .profile = aerosol,
                              .scattering = coefficient(aerosol, {0.05 * 0.92, 0.05 * 0.92, 0.30 * 0.90}),
                              .absorption = coefficient(aerosol, {0.05 * 0.08, 0.05 * 0.08, 0.30 * 0.10}),
                              .phase = HenyeyGreensteinPhase{spectrum<Number>(sky_wavelengths_nm, {0.76, 0.76, 0.80})}});
    a.constituents.push_back({.name = "absorber", .profile = absorber, .absorption = coefficient(absorber, {0.0012, 0.0280, 0.0210})});
    a.ground_albedo = spectrum<Number>(sky_wavelengths_nm, {0.1, 0.1, 0.2});
    return a;
}

// One of the slab_ cases of plane_parallel.csv, whose names say what they are.
inline Atmosphere slab(const std::string& name, double ground_albedo, Length radius) {
    const Length top = 100.0 * km;
    const auto number_after = [&](const char* word, double otherwise) {
        const std::size_t at = name.find(word);
        return at == std::string::npos ? otherwise : std::strtod(name.c_str() + at + std::string(word).size(), nullptr);
    };
    const double tau = number_after("_tau", 0.0), single = number_after("_ssa", 1.0);
    Atmosphere a;
    a.name = name;
    a.bottom_radius = radius;
    a.top_altitude = top;
    const auto constant = [](InverseLength x) { return SpectrumOf<InverseLength>::constant(x); };
    PhaseFunction phase = RayleighPhase{};
    if (name.find("_hg") != std::string::npos) phase = HenyeyGreensteinPhase{SpectrumOf<Number>::constant(number_after("_hg", 0.0))};
    a.constituents.push_back({.name = "slab",
                              .profile = LayerProfile{0.0 * km, top},
                              .scattering = constant(single * tau / top),
                              .absorption = constant((1.0 - single) * tau / top),
                              .phase = phase});
    a.ground_albedo = SpectrumOf<Number>::constant(ground_albedo);
    return a;
}

// The air of measured_sky_atmosphere.csv.
inline Atmosphere measured_sky(const std::vector<Row>& bands) {
    Atmosphere a;
    a.name = "Ithaca, 2013-05-27";
    a.bottom_radius = 6360.0 * km;
    a.top_altitude = 60.0 * km;
    std::vector<double> wavelengths;
    std::vector<InverseLength> rayleigh, scattering, absorption;
    std::vector<Number> albedo;
    std::vector<SpectralIrradiance> sun;
    for (const Row& band : bands) {
        wavelengths.push_back(band["wavelength_nm"]);
        rayleigh.push_back(band["rayleigh_scattering_m-1"] * per_m);
        scattering.push_back(band["aerosol_extinction_m-1"] * band["aerosol_single_scattering_albedo"] * per_m);
        absorption.push_back(band["aerosol_extinction_m-1"] * (1.0 - band["aerosol_single_scattering_albedo"]) * per_m);
        albedo.push_back(band["ground_albedo"]);
        sun.push_back(band["solar_irradiance_W_m-2_nm-1"] * W_per_m2_nm);
    }
    a.constituents.push_back(
        {.name = "air", .profile = ExponentialProfile{8.0 * km}, .scattering = spectrum(wavelengths, rayleigh), .phase = RayleighPhase{}});
    a.constituents.push_back({.name = "aerosol",
                              .profile = ExponentialProfile{1.2 * km},
                              .scattering = spectrum(wavelengths, scattering),
                              .absorption = spectrum(wavelengths, absorption),
                              .phase = CornetteShanksPhase{SpectrumOf<Number>::constant(0.7)}});
    a.ground_albedo = spectrum(wavelengths, albedo);
    a.sun.irradiance = spectrum(wavelengths, sun);
    return a;
}

}  // namespace airlight::truth
