// `airlight models`: every model of the sky, what it is and what it can answer: the survey's table 1 [Lopes2015], extended.

#include "models/model.h"

#include <fmt/format.h>

#include "command.h"

namespace airlight::cli {

namespace {

Result<Done> run() {
    fmt::print(
        "model,scattering,approach,precomputation,memory,highest_eye_m,highest_sun_zenith_deg,highest_view_zenith_deg,aerial_perspective,"
        "refused,paper\n");
    for (const Model& model : models()) {
        const ModelCard& c = model.card;
        const std::string highest_eye = c.highest_eye < anywhere ? fmt::format("{:g}", c.highest_eye.in(m)) : "space";
        fmt::print("{},\"{}\",\"{}\",\"{}\",\"{}\",{},{:g},{:g},{},\"{}\",{}\n", c.key, c.scattering, c.approach, c.precomputation,
                   c.memory, highest_eye, c.highest_sun_zenith_deg, c.highest_view_zenith_deg, c.aerial_perspective ? "yes" : "no",
                   c.refused, c.paper);
    }
    return Done{};
}

}  // namespace

Command models_command(CLI::App& airlight) {
    CLI::App* app = airlight.add_subcommand("models", "Print the models of the sky, and what each can answer.");
    app->footer(help_footer(
        "CSV, one row a model; `refused` says which views within the ranges it does not answer, `paper` is a key of docs/references.bib.",
        "airlight models"));
    return {app, [] { return run(); }};
}

}  // namespace airlight::cli
