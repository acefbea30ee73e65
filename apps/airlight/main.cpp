// The command line: one file a subcommand (command.h), each only parsing arguments and printing.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "command.h"

namespace {

using airlight::Done;
using airlight::Error;
using airlight::Result;
using airlight::cli::Command;

constexpr int done = 0;
constexpr int wrong_input = 1;
constexpr int wrong_usage = 2;

// What was printed has reached its file or pipe: a full disk is an error too.
Result<Done> printed() {
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return Done{};
    return Error{"standard output", fmt::format("cannot be written: {}", std::strerror(errno)), "Check that the disk is not full."};
}

int run(const Command& command) {
    Result<Done> result = command.run();
    if (result) result = printed();
    if (result) return done;
    fmt::print(stderr, "{}\n", result.error().message());
    return wrong_input;
}

std::string usage_message(const CLI::App* app, const CLI::Error& error) {
    while (!app->get_subcommands().empty()) app = app->get_subcommands().front();
    const std::string name = app->get_parent() == nullptr ? "airlight" : "airlight " + app->get_name();
    return fmt::format("{}: {}\n  See {} --help.\n", name, error.what(), name);
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Airlight: from a place, a time and a weather report to the light an eye sees."};
    app.formatter(std::make_shared<airlight::cli::HelpFormatter>());
    app.set_version_flag("--version", std::string("airlight ") + AIRLIGHT_VERSION, "print the version and stop");
    app.set_help_flag("-h,--help", "print this help and stop");
    app.failure_message(usage_message);
    app.require_subcommand(1);
    const std::vector<Command> commands = {
        airlight::cli::atmosphere_command(app), airlight::cli::bake_command(app),   airlight::cli::compare_command(app),
        airlight::cli::fit_command(app),        airlight::cli::mie_command(app),    airlight::cli::models_command(app),
        airlight::cli::probe_command(app),      airlight::cli::render_command(app), airlight::cli::sky_command(app),
        airlight::cli::sun_command(app),        airlight::cli::view_command(app),
    };
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? done : wrong_usage;  // 0: --help, --version
    }
    for (const Command& command : commands)
        if (command.syntax->parsed()) return run(command);
    return wrong_usage;
}
