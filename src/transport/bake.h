// The tables of one pack of wavelengths, by successive orders of scattering.
// Theory: docs/theory.md, section 5. Uses pack tables and harmonics.
#pragma once

#include "core/progress.h"
#include "core/result.h"
#include "transport/pack_tables.h"

namespace airlight {

struct BakeSettings {
    TableSizes sizes;
    // Orders of scattering that are computed, >= 1. With 1, only single scattering is seen.
    int orders = 5;
    // Whether the orders beyond are added as the geometric series that the last two computed begin (if orders >= 3).
    bool extrapolate = true;
    friend bool operator==(const BakeSettings&, const BakeSettings&) = default;
};

// Fails only if `progress` asks to stop. `begin` and `share` place this pack in a longer job's progress, 0 to 1.
Result<PackTables> bake_pack(const AirOptics& optics, const BakeSettings& settings, const Progress& progress, double begin = 0.0, double share = 1.0);

}  // namespace airlight
