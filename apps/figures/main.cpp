// Computes one figure: its table as CSV and its pictures as PNG. `make figures` calls it and draws the charts.

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "core/files.h"
#include "figure.h"

namespace {

using namespace airlight;

constexpr int wrong_input = 1;
constexpr int wrong_usage = 2;

Result<Done> write_figure(const figures::Figure& figure, const figures::Settings& settings) {
    std::error_code failed;
    std::filesystem::create_directories(settings.folder, failed);
    const std::filesystem::path path = settings.folder / fmt::format("{}.csv", figure.name);
    if (const Result<Done> possible = can_write(path); !possible) return possible.error();
    const Result<figures::Table> table = figure.make(settings);
    if (!table) return table.error();
    if (const Result<Done> written = write_file(path, figures::csv(*table)); !written) return written.error();
    fmt::print("{}\n", path.string());
    return Done{};
}

std::string known_figures() {
    std::string text = "Figures:";
    for (const figures::Figure& figure : figures::figures()) text += fmt::format("\n  {:<24}  {}", figure.name, figure.what);
    return text;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Compute a figure of docs/gallery.md: FOLDER/NAME.csv and, where it shows skies, FOLDER/NAME-ROW-COLUMN.png."};
    std::string name, folder;
    bool tiny = false, quiet = false;
    app.add_option("name", name, "which figure")->required();
    app.add_option("-o,--output", folder, "where it goes; tables of light are kept there too")->required();
    app.add_flag("--small", tiny, "little of everything, for tests");
    app.add_flag("--quiet", quiet, "no progress on standard error");
    app.footer(known_figures());
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : wrong_usage;
    }
    const figures::Figure* figure = figures::find_figure(name);
    if (!figure) {
        fmt::print(stderr, "\"{}\" is no figure\n  {}\n", name, known_figures());
        return wrong_input;
    }
    figures::Settings settings = tiny ? figures::small(folder) : figures::Settings{.folder = folder};
    ProgressLine line(quiet);
    settings.progress = line.progress();
    const Result<Done> written = write_figure(*figure, settings);
    if (written) return 0;
    fmt::print(stderr, "{}\n", written.error().message());
    return wrong_input;
}
