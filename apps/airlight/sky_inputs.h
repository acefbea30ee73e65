// What `sky` and `probe` both ask for: the air, the weather, the wavelengths and the model; and the sky that answers.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "air_inputs.h"
#include "core/progress.h"
#include "core/result.h"
#include "sky/sky.h"
#include "spectrum/wavelength_grid.h"
#include "transport/bake_settings.h"

namespace airlight::cli {

struct SkyInputs {
    AirInputs air;
    std::string wavelengths = "standard";
    std::string model = "tables";
    std::optional<double> turbidity;
    std::string data;
    int cie_type = 12;
    std::optional<double> clearness;
    std::optional<double> brightness;
    std::string variant;
    std::string sizes;
    int orders = BakeSettings{}.orders;
    std::int64_t paths = 16384;
    std::uint64_t seed = 1;
    std::string cache;
    bool quiet = false;
};

// Declares the options that fill `inputs`.
void add_sky_inputs(CLI::App& app, SkyInputs& inputs);

struct AskedSky {
    Atmosphere atmosphere;
    std::vector<std::string> decisions;  // what was taken from the weather report
    WavelengthGrid wavelengths;
    std::unique_ptr<Sky> sky;
};

// Bakes or loads tables if the model wants them.
Result<AskedSky> asked_sky(const SkyInputs& inputs, const Progress& progress);

}  // namespace airlight::cli
