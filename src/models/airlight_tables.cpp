#include "models/airlight_tables.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/parallel.h"
#include "core/quadrature.h"

namespace airlight {

namespace {

// Of sixteen wavelengths and 16 bits: 3.1 MiB of source, 0.5 MiB of transmittance.
constexpr TableSizes sizes = {.transmittance_mu = 256, .transmittance_altitude = 64, .sun = 40, .azimuth = 8, .view = 16, .altitude = 20};
constexpr int density_texels = 1024;

// Optical depths: less is nothing, and beyond the deepest nothing is seen, for e^-64 is 2e-28.
constexpr float least_depth = 1e-6f, deepest_depth = 64.0f;
// The source over the sun's irradiance: between the brightest that scattering makes of it, and night.
constexpr float log_low = -26.0f;
constexpr float log_range = 28.0f;

std::uint16_t packed(float value) { return static_cast<std::uint16_t>(std::clamp(value, 0.0f, 1.0f) * 65535.0f + 0.5f); }

void pack_spectrum(const f32::Spectrum& spectrum, std::uint16_t* texel) {
    for (int w = 0; w < pack_size; ++w) texel[w] = packed(spectrum.v[w]);
}

std::uint16_t* texel(PackedTexels& table, int i, int j, int k) {
    const auto at = (static_cast<std::size_t>(k) * static_cast<std::size_t>(table.size[1]) + static_cast<std::size_t>(j)) *
                        static_cast<std::size_t>(table.size[0]) +
                    static_cast<std::size_t>(i);
    return &table.values[at * static_cast<std::size_t>(pack_size)];
}

PackedTexels packed_texels(std::array<int, 3> size) {
    PackedTexels table{size, {}};
    table.values.resize(static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(size[2]) *
                        static_cast<std::size_t>(pack_size));
    return table;
}

// The logarithm of a quantity over the sun's irradiance, as it is packed.
template <class Cell, int D>
Table<Cell, D> logarithms(const Table<Cell, D>& table, const f32::IrradianceSpectrum& solar) {
    Table<Cell, D> logs = table;
    const auto cells = logs.cells();
    parallel_for(cells.size(), [&](std::size_t i) {
        for (int w = 0; w < pack_size; ++w) cells[i].v[w] = (std::log(std::max(cells[i].v[w] / solar.v[w], 1e-30f)) - log_low) / log_range;
    });
    return logs;
}

// The texels of a table with `size` that the texel i of `count` of another one lies between: both go from 0 to 1.
Texels texels_of(int i, int count, int size) {
    return texels_at(f32::texture_coordinate(f32::Number(static_cast<double>(i) / (count - 1)), size).value, size);
}

PackedTexels packed_source(const Tables::Pack& pack, const AltitudeAxis& axis) {
    const Table<f32::RadianceSpectrum, 4> logs = logarithms(pack.tables.source, pack.air.solar_irradiance);
    const auto& from = logs.size();
    PackedTexels table = packed_texels({sizes.sun, sizes.view, axis.size() * sizes.azimuth});
    parallel_for(static_cast<std::size_t>(axis.size()), [&](std::size_t l) {
        const Texels altitude = pack.air.source_axis.at(static_cast<float>(axis.inner_altitude_m(static_cast<int>(l))));
        for (int j = 0; j < sizes.azimuth; ++j)
            for (int k = 0; k < sizes.view; ++k)
                for (int i = 0; i < sizes.sun; ++i) {
                    const f32::RadianceSpectrum value = logs.at({texels_of(i, sizes.sun, from[0]), texels_of(j, sizes.azimuth, from[1]),
                                                                 texels_of(k, sizes.view, from[2]), altitude});
                    std::uint16_t* to = texel(table, i, k, static_cast<int>(l) + axis.size() * j);
                    for (int w = 0; w < pack_size; ++w) to[w] = packed(value.v[w]);
                }
    });
    return table;
}

PackedTexels packed_diffuse(const Tables::Pack& pack) {
    const Table<f32::IrradianceSpectrum, 2> logs = logarithms(pack.tables.irradiance, pack.air.solar_irradiance);
    PackedTexels table = packed_texels({sizes.sun, 1, 1});
    for (int i = 0; i < sizes.sun; ++i) {
        const f32::IrradianceSpectrum value = logs.at({texels_of(i, sizes.sun, logs.size()[0]), Texels{0, 0, 0.0f}});
        std::uint16_t* to = texel(table, i, 0, 0);
        for (int w = 0; w < pack_size; ++w) to[w] = packed(value.v[w]);
    }
    return table;
}

PackedTexels packed_transmittance(const PackAir& air) {
    const Table<f32::Spectrum, 2> logarithms = transmittance_table(air, sizes.transmittance_mu);
    const float least = std::log(least_depth / thinnest_depth), range = std::log(deepest_depth / least_depth);
    PackedTexels table = packed_texels({sizes.transmittance_mu, air.transmittance_axis.size(), 1});
    for (int j = 0; j < air.transmittance_axis.size(); ++j)
        for (int i = 0; i < sizes.transmittance_mu; ++i)
            pack_spectrum((logarithms[{i, j}] - f32::Spectrum(f32::Number::of(least))) / f32::Number::of(range), texel(table, i, j, 0));
    return table;
}

}  // namespace

f32::AirlightAxis airlight_axis(const AltitudeAxis& axis) {
    f32::AirlightAxis a{};
    a.segments = static_cast<int>(axis.segments().size());
    a.texels = axis.size();
    for (int s = 0; s < a.segments; ++s) {
        const AltitudeAxis::Segment& segment = axis.segments()[static_cast<std::size_t>(s)];
        a.from[s] = f32::Number::of(segment.from);
        a.inverse_range[s] = f32::Number::of(segment.inverse_range);
        a.first[s] = f32::Number(segment.first);
        a.last[s] = f32::Number(segment.last);
        a.crowds[s] = f32::Number(segment.crowds ? 1.0 : 0.0);
    }
    return a;
}

namespace {

// Altitudes of jumps, as many as the text has room for.
std::span<const double> jumps_of(const PackAir& air) {
    const std::span<const double> all = air.densities.jumps_m();
    return all.first(std::min(all.size(), static_cast<std::size_t>(f32::airlight_segments - 1)));
}

std::vector<f32::Spectrum> density_rows(const PackAir& air, const AltitudeAxis& axis) {
    std::vector<f32::Spectrum> rows(2 * static_cast<std::size_t>(axis.size()), f32::Spectrum(f32::Number(0.0)));
    for (int i = 0; i < axis.size(); ++i) {
        float densities[max_parts]{};
        air.densities.at(static_cast<float>(axis.inner_altitude_m(i)), densities);
        for (int p = 0; p < air.parts; ++p) rows[static_cast<std::size_t>(i + (p < 4 ? 0 : axis.size()))].v[p % 4] = densities[p];
    }
    return rows;
}

}  // namespace

std::size_t AirlightTables::bytes() const {
    return 2 * (transmittance.values.size() + source.values.size() + diffuse.values.size()) + densities.size() * sizeof(densities[0]);
}

f32::AirlightLight AirlightTables::light(const f32::AirlightRay& ray) const {
    return f32::airlight_light(air, density_table(), transmittance_table(), source_table(), diffuse_table(), ray);
}

f32::IrradianceSpectrum AirlightTables::diffuse_on_ground(float mu_s) const {
    return f32::airlight_diffuse(air, diffuse_table(), f32::Number::of(mu_s)) * air.solar_irradiance;
}

f32::AirlightRule airlight_rule(int nodes) {
    assert(nodes >= 2 && nodes <= f32::airlight_nodes);
    const GaussRule gauss = gauss_rule(nodes, 0.0, 1.0);
    f32::AirlightRule rule{};
    rule.count = nodes;
    for (int k = 0; k < nodes; ++k) {
        rule.node[k] = gauss.nodes[static_cast<std::size_t>(k)];
        rule.weight[k] = gauss.weights[static_cast<std::size_t>(k)];
    }
    return rule;
}

AirlightTables airlight_medium(const PackAir& air, const TableSizes& sizes, int nodes) {
    const AltitudeAxis density_axis(air.shell.top_m, jumps_of(air), density_texels);
    AirlightTables t{};
    t.air.bottom = f32::Length::of(static_cast<float>(air.shell.bottom_m));
    t.air.top = f32::Length::of(static_cast<float>(air.shell.top_m));
    t.air.parts = air.parts;
    for (int p = 0; p < f32::airlight_parts; ++p) {
        const auto i = static_cast<std::size_t>(p);
        t.air.scattering[p] = air.scattering[i];
        t.air.extinction[p] = air.extinction[i];
        t.air.opacity[p] = f32::InverseLength::of(air.opacity[i]);
    }
    t.air.ground_albedo = air.ground_albedo;
    t.air.solar_irradiance = air.solar_irradiance;
    t.air.sun_radius = f32::Number::of(air.sun_angular_radius);
    t.air.density_axis = airlight_axis(density_axis);
    t.air.transmittance_axis = airlight_axis(air.transmittance_axis);
    t.air.source_axis = airlight_axis(air.source_axis);
    t.air.least_depth = f32::Number::of(least_depth);
    t.air.depth_range = f32::Number::of(std::log(deepest_depth / least_depth));
    t.air.log_low = f32::Number::of(log_low);
    t.air.log_range = f32::Number::of(log_range);
    t.air.sun_texels = sizes.sun;
    t.air.azimuth_texels = sizes.azimuth;
    t.air.view_texels = sizes.view;
    t.air.cosine_texels = sizes.transmittance_mu;
    t.air.rule = airlight_rule(nodes);
    t.densities = density_rows(air, density_axis);
    return t;
}

AirlightTables airlight_tables(const Tables::Pack& pack, int nodes) {
    const PackAir air = pack_air(pack.optics, sizes);
    AirlightTables t = airlight_medium(air, sizes, nodes);
    t.transmittance = packed_transmittance(air);
    t.source = packed_source(pack, air.source_axis);
    t.diffuse = packed_diffuse(pack);
    return t;
}

}  // namespace airlight
