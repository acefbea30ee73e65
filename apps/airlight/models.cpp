// `airlight models`: what can be asked for light, and what each can answer.

#include <fmt/format.h>

#include "command.h"

namespace airlight::cli {

namespace {

struct Model {
    std::string_view key, scattering, approach, precomputation, altitude, sun_zenith_deg, aerial_perspective, memory;
};

constexpr Model models[] = {
    {"reference", "all orders", "Monte Carlo on spherical shells, double precision, with standard errors", "none", "ground to space",
     "0-180", "transmittance", "below 1 MiB"},
    {"tables", "single exact; higher orders from tables",
     "single scattering integrated along the ray, higher orders from the table of their source", "seconds a pack of 16 wavelengths",
     "ground to space", "0-180 (dark beyond 120)", "transmittance", "66 MiB a pack at the default sizes"},
};

Result<Done> run() {
    fmt::print("model,scattering,approach,precomputation,altitude,sun_zenith_deg,aerial_perspective,memory\n");
    for (const Model& x : models)
        fmt::print("{},{},\"{}\",\"{}\",{},{},{},{}\n", x.key, x.scattering, x.approach, x.precomputation, x.altitude, x.sun_zenith_deg,
                   x.aerial_perspective, x.memory);
    return Done{};
}

}  // namespace

Command models_command(CLI::App& airlight) {
    CLI::App* app = airlight.add_subcommand("models", "Print the models of the sky, and what each can answer.");
    app->footer(help_footer("CSV, one row a model.", "airlight models"));
    return {app, [] { return run(); }};
}

}  // namespace airlight::cli
