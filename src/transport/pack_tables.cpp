#include "transport/pack_tables.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "transport/pack_arithmetic.h"

namespace airlight {

namespace {

f32::Length metres(double x) { return f32::Length::of(static_cast<float>(x)); }

// The part of a uniform disk that stands above a straight horizon; x is the height of its centre in units of its radius.
float disk_above(float x) {
    if (x <= -1.0f) return 0.0f;
    if (x >= 1.0f) return 1.0f;
    return 0.5f + (x * std::sqrt(1.0f - x * x) + std::asin(x)) / static_cast<float>(pi);
}

}  // namespace

f32::Spectrum optical_depth_of(const PackAir& air, const float* columns_m) {
    return weighted_sum(air.extinction, columns_m, air.parts) * f32::m;
}

f32::Spectrum transmittance_of(const PackAir& air, const float* columns_m) { return exp(-optical_depth_of(air, columns_m)); }

PackAir pack_air(const AirOptics& optics, const TableSizes& sizes) {
    std::vector<DensityProfile> profiles;
    for (const AirOptics::Part& part : optics.parts) profiles.push_back(part.profile);
    const double top_m = optics.top_altitude.value;
    const DensityTable densities(profiles, airlight::Length::of(top_m));
    PackAir air{.shell = {optics.bottom_radius.value, top_m},
                .densities = densities,
                .parts = static_cast<int>(optics.parts.size()),
                .scattering = {},
                .extinction = {},
                .ground_albedo = narrowed<f32::Spectrum>(optics.ground_albedo),
                .solar_irradiance = narrowed<f32::IrradianceSpectrum>(optics.solar_irradiance),
                .sun_angular_radius = static_cast<float>(optics.sun.angular_radius),
                .opacity = {},
                .transmittance_axis = AltitudeAxis(top_m, densities.jumps_m(), sizes.transmittance_altitude),
                .source_axis = AltitudeAxis(top_m, densities.jumps_m(), sizes.altitude)};
    for (std::size_t p = 0; p < optics.parts.size(); ++p) {
        air.scattering[p] = narrowed<f32::ScatteringSpectrum>(optics.parts[p].scattering);
        air.extinction[p] = narrowed<f32::ScatteringSpectrum>(optics.parts[p].extinction);
        air.opacity[p] = *std::max_element(air.extinction[p].v, air.extinction[p].v + pack_size);
    }
    return air;
}

Table<f32::Spectrum, 2> transmittance_table(const PackAir& air, int mu_size) {
    Table<f32::Spectrum, 2> table({mu_size, air.transmittance_axis.size()});
    const f64::Length bottom = f64::Length::of(air.shell.bottom_m);
    const f64::Length top = f64::Length::of(air.shell.top_m);
    parallel_for(static_cast<std::size_t>(air.transmittance_axis.size()), [&](std::size_t j) {
        const f64::Length h = f64::Length::of(air.transmittance_axis.altitude_m(static_cast<int>(j)));
        RayNodes nodes;
        for (int i = 0; i < mu_size; ++i) {
            // A hair above the horizon, so that the last ray does not meet the ground by rounding.
            const double mu =
                std::max(f64::transmittance_cosine_of_coordinate(h, static_cast<double>(i) / (mu_size - 1), bottom, top).value,
                         f64::horizon_cosine(h, bottom).value + 1e-12);
            sample_ray(air.shell, {h.value, mu, 1.0, mu}, air.densities, {}, RayNodes::max_per_piece, nodes);
            const f32::Spectrum depth = optical_depth_of(air, nodes.total_column_m);
            f32::Spectrum& texel = table[{i, static_cast<int>(j)}];
            for (int w = 0; w < pack_size; ++w) texel.v[w] = std::log(std::max(depth.v[w], thinnest_depth) / thinnest_depth);
        }
    });
    return table;
}

f32::Spectrum sun_transmittance(const PackAir& air, const Table<f32::Spectrum, 2>& transmittance, float altitude_m, float mu_s) {
    const f32::Length bottom = metres(air.shell.bottom_m);
    const f32::Length top = metres(air.shell.top_m);
    const f32::Length h = f32::Length::of(altitude_m);
    const float horizon = f32::horizon_cosine(h, bottom).value;
    const float sine = std::sqrt(std::max(1.0f - horizon * horizon, 1e-6f));
    const float above = (mu_s - horizon) / sine;  // the height of the sun's centre above the horizon, in radians
    const float part = air.sun_angular_radius > 0.0f ? disk_above(above / air.sun_angular_radius) : (above >= 0.0f ? 1.0f : 0.0f);
    if (part == 0.0f) return zero<f32::Spectrum>();
    const f32::Number x = f32::transmittance_cosine_coordinate(h, f32::Number(std::max(mu_s, horizon)), bottom, top);
    const int size = transmittance.size()[0];
    const f32::Spectrum logarithm =
        transmittance.at({texels_at(f32::texture_coordinate(x, size).value, size), air.transmittance_axis.at(altitude_m)});
    return exp(exp(logarithm) * -f32::Number::of(thinnest_depth)) * f32::Number(part);
}

f32::IrradianceSpectrum direct_irradiance(const PackAir& air, const Table<f32::Spectrum, 2>& transmittance, float altitude_m, float mu_s) {
    // Near the horizon, the part of the disk that is above the plane faces it at about half its height.
    const float radius = air.sun_angular_radius;
    const float facing = mu_s >= radius ? mu_s : std::max(0.0f, 0.5f * (mu_s + radius));
    if (facing == 0.0f) return zero<f32::IrradianceSpectrum>();
    return air.solar_irradiance * sun_transmittance(air, transmittance, altitude_m, mu_s) * f32::Number(facing);
}

}  // namespace airlight
