#include <fmt/format.h>

#include "command.h"

namespace airlight::cli {

namespace {

std::string typed(const CLI::Option& option) {
    std::string text = option.get_positional() ? "" : option.get_name(false, true);
    if (!option.get_option_text().empty()) text += (text.empty() ? "" : " ") + option.get_option_text();
    return text;
}

std::string usage(const CLI::App& app) {
    std::string text = "usage: airlight";
    if (app.get_parent() == nullptr) return text + " <command> [options]\n";
    text += " " + app.get_name();
    for (const CLI::Option* option : app.get_options())
        if (option->get_required()) text += " " + typed(*option);
        else if (option->get_positional()) text += " [" + typed(*option) + "]";
    return text + " [options]\n";
}

std::string option_line(const CLI::Option& option) {
    std::string note;
    if (option.get_required()) note = "  (required)";
    else if (!option.get_default_str().empty()) note = fmt::format("  (default: {})", option.get_default_str());
    return fmt::format("  {:<24}  {}{}\n", typed(option), option.get_description(), note);
}

}  // namespace

std::string help_footer(const std::string& output, const std::string& example) {
    return fmt::format("Output: {}\nExit:   0 done; 1 the input is wrong; 2 wrong usage\nExample: {}", output, example);
}

std::string HelpFormatter::make_help(const CLI::App* app, std::string, CLI::AppFormatMode) const {
    std::string text = fmt::format("{}\n{}\n\n", usage(*app), app->get_description());
    for (const CLI::App* command : app->get_subcommands({}))
        text += fmt::format("  {:<24}  {}\n", command->get_name(), command->get_description());
    if (!app->get_subcommands({}).empty()) text += "\n";
    for (const CLI::Option* option : app->get_options()) text += option_line(*option);
    if (!app->get_footer().empty()) text += "\n" + app->get_footer() + "\n";
    return text;
}

}  // namespace airlight::cli
