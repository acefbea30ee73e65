// The command line: one file a subcommand, each only parsing arguments and printing.

#include <CLI/CLI.hpp>
#include <string>

int main(int argc, char** argv) {
    CLI::App app{"Airlight: from a place, a time and a weather report to the light an eye sees."};
    app.set_version_flag("--version", std::string("airlight ") + AIRLIGHT_VERSION);
    app.require_subcommand(0, 1);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        const bool asked = error.get_exit_code() == 0;  // --help, --version
        app.exit(error);
        return asked ? 0 : 2;
    }
    return 0;
}
