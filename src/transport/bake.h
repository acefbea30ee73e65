// The tables of one pack of wavelengths, by successive orders of scattering.
// Theory: docs/theory.md, sections 5.3 and 5.4. Uses pack tables and harmonics.
#pragma once

#include <functional>

#include "core/progress.h"
#include "core/result.h"
#include "transport/bake_settings.h"
#include "transport/pack_tables.h"

namespace airlight {

// A bake between two orders: all that the orders still to come need.
struct BakeState {
    int orders_done = 0;                               // with 0, the tables below may be empty
    Table<f32::RadianceSpectrum, 4> source;            // of the last order done, as in PackTables
    Table<f32::IrradianceSpectrum, 2> irradiance;      // of the last order done
    Table<f32::RadianceSpectrum, 4> source_sum;        // of all orders done
    Table<f32::IrradianceSpectrum, 2> irradiance_sum;  // of all orders done
};

// Where a bake begins, and who is told of each finished order but the last: the state is good until the call returns.
struct BakeSteps {
    BakeState from = {};  // of a bake of the same optics and settings
    std::function<void(const BakeState&)> order_done = [](const BakeState&) {};
};

// Fails only if `progress` asks to stop. A bake that goes on from a state ends in the same bits as one without a stop.
Result<PackTables> bake_pack(const AirOptics& optics, const BakeSettings& settings, const Progress& progress, BakeSteps steps = {});

}  // namespace airlight
