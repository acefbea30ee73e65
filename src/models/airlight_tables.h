// What the model `airlight` reads at run time: the tables of an atmosphere at up to sixteen wavelengths in at most 4 MiB,
// and the small structures of physics/models/airlight.glsl, ready for a GPU's textures and blocks as for the CPU.
// Theory: docs/theory.md, section 10.1. Uses transport's tables, from which these are made.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/models/f32.h"
#include "transport/tables.h"

namespace airlight {

// Texels of 16 bits, sixteen wavelengths each: values of 0 to 1.
struct PackedTexels {
    std::array<int, 3> size{1, 1, 1};  // width, height, depth
    std::vector<std::uint16_t> values;
};

struct AirlightTables {
    f32::AirlightAir air;
    std::vector<f32::Spectrum> densities;  // [2][density_axis.texels]
    PackedTexels transmittance;            // optical depths, [altitude][cosine]
    PackedTexels source;                   // logarithms, [azimuth][altitude][view][sun]
    PackedTexels diffuse;                  // logarithms of the irradiance on the ground, [sun]

    std::size_t bytes() const;

    // As the text reads them.
    Table2D<f32::Spectrum> density_table() const { return {densities, air.density_axis.texels, 2}; }
    PackedTable2D<f32::Spectrum> transmittance_table() const {
        return {transmittance.values.data(), transmittance.size[0], transmittance.size[1]};
    }
    PackedTable3D<f32::Spectrum> source_table() const { return {source.values.data(), source.size[0], source.size[1], source.size[2]}; }
    PackedTable2D<f32::Spectrum> diffuse_table() const { return {diffuse.values.data(), diffuse.size[0], 1}; }

    f32::AirlightLight light(const f32::AirlightRay& ray) const;
    // Of a level surface on the ground, by the whole sky but the sun's disk.
    f32::IrradianceSpectrum diffuse_on_ground(float mu_s) const;
};

// The air alone, its densities, and the shape of tables of these sizes, which are left empty. `nodes`: of a piece of a ray, 2 to
// airlight_nodes. `air`: made for the same sizes.
AirlightTables airlight_medium(const PackAir& air, const TableSizes& sizes, int nodes);

// The same axis as the shared text reads it: of at most airlight_segments segments.
f32::AirlightAxis airlight_axis(const AltitudeAxis& axis);

// Samples the tables of a pack anew, geometrically between their texels.
AirlightTables airlight_tables(const Tables::Pack& pack, int nodes);

// Gauss's rule of 2 to airlight_nodes nodes.
f32::AirlightRule airlight_rule(int nodes);

}  // namespace airlight
