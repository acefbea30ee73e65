// One file a subcommand: each declares its options and its help, calls the library, and prints; nothing else.
// To add one: apps/airlight/NAME.cpp with `Command NAME_command(CLI::App& airlight)`, a line below, a line in main.cpp
// and one in CMakeLists.txt; tests/cli/help/NAME.txt and its cases in tests/cli/CMakeLists.txt.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "core/result.h"

namespace airlight::cli {

// A subcommand. What the user may type is CLI11's business (exit code 2 if broken); what the values mean is `run`'s:
// its Error is printed on the standard error stream and ends the program with exit code 1.
struct Command {
    CLI::App* syntax;
    std::function<Result<Done>()> run;
};

// The text below the options: what is printed, the exit codes, an example that the tests run.
std::string help_footer(const std::string& output, const std::string& example);

// Help in this project's form: usage, purpose, one line an option ("--sun <deg>  what  (default: 45)"), footer.
class HelpFormatter : public CLI::Formatter {
public:
    std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
};

Command atmosphere_command(CLI::App& airlight);
Command bake_command(CLI::App& airlight);
Command compare_command(CLI::App& airlight);
Command fit_command(CLI::App& airlight);
Command mie_command(CLI::App& airlight);
Command models_command(CLI::App& airlight);
Command probe_command(CLI::App& airlight);
Command render_command(CLI::App& airlight);
Command sky_command(CLI::App& airlight);
Command sun_command(CLI::App& airlight);
Command view_command(CLI::App& airlight);

}  // namespace airlight::cli
