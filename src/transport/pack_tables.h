// What a bake leaves for sixteen wavelengths, and sunlight as it is read from it.
// Theory: docs/theory.md, section 5. Uses tables, ray nodes and physics (f32).
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "transport/air_optics.h"
#include "transport/altitude_axis.h"
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
    Opacity opacity;
    AltitudeAxis transmittance_axis;
    AltitudeAxis source_axis;  // of irradiance too
};

PackAir pack_air(const AirOptics& optics, const TableSizes& sizes);

struct PackTables {
    Table<f32::Spectrum, 2> transmittance;         // [mu][altitude]: from a point to the top of the atmosphere: the logarithm of the
                                                   // optical depth over thinnest_depth, 0 or more; so depths between texels are geometric
    Table<f32::RadianceSpectrum, 4> source;        // [sun][azimuth][view][altitude]: radiance scattered, by light of at least one
                                                   // scattering or reflection, per scattering coefficient (all orders summed)
    Table<f32::IrradianceSpectrum, 2> irradiance;  // [sun][altitude]: diffuse, on a level surface facing up
};

// The sum over parts of spectrum times amount. One loop for each number of parts: with a number not known when compiling,
// the compiler fills vector registers with parts instead of wavelengths (4 times slower).
template <int P, class S>
AIRLIGHT_INLINE S weighted_sum_of(const std::array<S, max_parts>& spectra, const float* amounts) {
    S sum;
    for (int w = 0; w < pack_size; ++w) sum.v[w] = spectra[0].v[w] * amounts[0];
    for (std::size_t p = 1; p < P; ++p)
        for (int w = 0; w < pack_size; ++w) sum.v[w] += spectra[p].v[w] * amounts[p];
    return sum;
}
template <class S>
AIRLIGHT_INLINE S weighted_sum(const std::array<S, max_parts>& spectra, const float* amounts, int parts) {
    switch (parts) {
        case 1:
            return weighted_sum_of<1>(spectra, amounts);
        case 2:
            return weighted_sum_of<2>(spectra, amounts);
        case 3:
            return weighted_sum_of<3>(spectra, amounts);
        case 4:
            return weighted_sum_of<4>(spectra, amounts);
        case 5:
            return weighted_sum_of<5>(spectra, amounts);
        case 6:
            return weighted_sum_of<6>(spectra, amounts);
        case 7:
            return weighted_sum_of<7>(spectra, amounts);
        default:
            return weighted_sum_of<max_parts>(spectra, amounts);
    }
}

// Transmittance from a point to the sun, times the part of its disk that stands above the horizon.
f32::Spectrum sun_transmittance(const PackAir& air, const Table<f32::Spectrum, 2>& transmittance, float altitude_m, float mu_s);

// Irradiance of a level plane facing up by the sun's disk.
f32::IrradianceSpectrum direct_irradiance(const PackAir& air, const Table<f32::Spectrum, 2>& transmittance, float altitude_m, float mu_s);

// Optical depth of the given columns of each part's air (relative density times length, in metres).
f32::Spectrum optical_depth_of(const PackAir& air, const float* columns_m);

// Transmittance through the given columns of each part's air (relative density times length, in metres).
f32::Spectrum transmittance_of(const PackAir& air, const float* columns_m);

// Optical depths below it are held as this one.
inline constexpr float thinnest_depth = 1e-12f;

// The transmittance table of an atmosphere.
Table<f32::Spectrum, 2> transmittance_table(const PackAir& air, int mu_size);

}  // namespace airlight
