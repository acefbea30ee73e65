// What a bake leaves for sixteen wavelengths, and the light along a ray that is read from it.
// Theory: docs/theory.md, section 5. Uses tables, ray nodes and physics (f32).
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "transport/air_optics.h"
#include "transport/bake_settings.h"
#include "transport/density_table.h"
#include "transport/ray_nodes.h"
#include "transport/table.h"

namespace airlight {

// An atmosphere at a pack of wavelengths in single precision, for inner loops.
struct PackAir {
    Shell shell;
    DensityTable densities;
    int parts;
    std::array<f32::ScatteringSpectrum, max_parts> scattering;  // where the density is 1
    std::array<f32::ScatteringSpectrum, max_parts> extinction;
    f32::Spectrum ground_albedo;
    f32::IrradianceSpectrum solar_irradiance;
    float sun_angular_radius;
    float free_path_at(float altitude_m) const;  // the shortest of the pack's, in metres
};

PackAir pack_air(const AirOptics& optics);

struct PackTables {
    Table<f32::Spectrum, 2> transmittance;         // [mu][altitude]: from a point to the top of the atmosphere
    Table<f32::RadianceSpectrum, 4> source;        // [sun][azimuth][view][altitude]: radiance scattered, by light of at least one
                                                   // scattering or reflection, per scattering coefficient (all orders summed)
    Table<f32::IrradianceSpectrum, 2> irradiance;  // [sun][altitude]: diffuse, on a level surface facing up
};

// Transmittance from a point to the sun, times the part of its disk that stands above the horizon.
f32::Spectrum sun_transmittance(const PackAir& air, const Table<f32::Spectrum, 2>& transmittance, float altitude_m, float mu_s);

// Irradiance of a level plane facing up by the sun's disk.
f32::IrradianceSpectrum direct_irradiance(const PackAir& air, const Table<f32::Spectrum, 2>& transmittance, float altitude_m, float mu_s);

// Transmittance through the given columns of each part's air (relative density times length, in metres).
f32::Spectrum transmittance_of(const PackAir& air, const float* columns_m);

// The transmittance table of an atmosphere.
Table<f32::Spectrum, 2> transmittance_table(const PackAir& air, const TableSizes& sizes);

// Light that reaches the start of a ray, apart from the sun's disk itself.
struct RayLight {
    f32::RadianceSpectrum multiple;                               // two and more scatterings, and light from the ground
    std::array<f32::IrradianceSpectrum, max_parts> single;        // one scattering in each constituent; times its phase function it is radiance
    f32::Spectrum transmittance;                                  // to the end of the ray
};

// What the light along a ray is gathered from.
struct Gathered {
    bool single = true;
    const Table<f32::RadianceSpectrum, 4>* source = nullptr;             // of higher orders; null: none
    const Table<f32::IrradianceSpectrum, 2>* diffuse_on_ground = nullptr;  // null: none
    bool direct_on_ground = true;
};

// Integrates along `nodes`, a ray whose cosine to the sun is `nu`.
RayLight gather(const PackAir& air, const Table<f32::Spectrum, 2>& transmittance, const Gathered& what, const RayNodes& nodes, float nu);

}  // namespace airlight
