// How finely a bake samples an atmosphere: the sizes of its tables, and the orders of scattering that it computes.
// Uses nothing of the atmosphere.
#pragma once

#include <string>
#include <string_view>

#include "core/result.h"

namespace airlight {

// Texels of the tables: each count is at least 2.
struct TableSizes {
    int transmittance_mu = 256;
    int transmittance_altitude = 128;
    int sun = 64;  // cosine of the sun's zenith angle
    int azimuth = 16;
    int view = 32;  // view zenith angle
    int altitude = 32;
    friend bool operator==(const TableSizes&, const TableSizes&) = default;
};

struct BakeSettings {
    TableSizes sizes;
    // Orders of scattering that are computed, >= 1. With 1, only single scattering is seen.
    int orders = 6;
    // Whether the orders beyond are added as the geometric series that the last two computed begin (if orders >= 3).
    bool extrapolate = true;
    friend bool operator==(const BakeSettings&, const BakeSettings&) = default;
};

// The same settings, or the first rule that they break: sizes of 2 to 4096 texels, source tables of at most 2^25 texels (which
// take 6 GiB while baked), 1 to 100 orders.
Result<BakeSettings> validated(BakeSettings settings);

// Sizes as people write them: "64x16x32x32" (sun, azimuth, view, altitude), the transmittance as it is by default,
// or "64x16x32x32,256x128" (with transmittance: angle, altitude).
Result<TableSizes> parse_table_sizes(std::string_view text);
std::string table_sizes_text(const TableSizes& sizes);

}  // namespace airlight
