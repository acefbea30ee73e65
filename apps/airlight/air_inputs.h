// What every command about air asks for: the air by name or file, and the weather report that changes it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "atmosphere/atmosphere.h"
#include "core/result.h"
#include "optics/aerosol.h"

namespace airlight::cli {

struct AirInputs {
    std::string atmosphere;
    std::string metar;
    std::string aerosol = "continental_average";
};

// Declares the options that fill `inputs`; the name is not required here.
CLI::Option* add_air_inputs(CLI::App& app, AirInputs& inputs);

struct AskedAir {
    Atmosphere atmosphere;
    std::vector<std::string> decisions;  // what was taken from the weather report, one line each
};
Result<AskedAir> asked_air(const AirInputs& inputs);

// An air under a weather report: its text, or a file that has it. Fails if it is none.
Result<AskedAir> air_under(Atmosphere base, const std::string& text_or_file, AerosolType usual_aerosol);

}  // namespace airlight::cli
