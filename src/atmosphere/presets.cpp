#include "atmosphere/presets.h"

#include <fmt/format.h>

#include "atmosphere/atmosphere_file.h"

namespace airlight {

namespace {

struct PresetFile {
    std::string_view name, text;
};
constexpr PresetFile files[] = {
#include "preset_files.inc"
};

}  // namespace

std::vector<std::string_view> preset_names() {
    std::vector<std::string_view> names;
    for (const PresetFile& file : files) names.push_back(file.name);
    return names;
}

Result<std::string_view> preset_text(std::string_view name) {
    std::string words;
    for (const PresetFile& file : files) {
        if (file.name == name) return file.text;
        words += std::string(file.name) + ' ';
    }
    const std::string near = nearest_word(name, words);
    return Error{
        "", fmt::format("\"{}\" is no preset", name),
        near.empty() ? fmt::format("There are: {}.", words.substr(0, words.size() - 1)) : fmt::format("Did you mean \"{}\"?", near)};
}

Result<Atmosphere> preset(std::string_view name) {
    const Result<std::string_view> text = preset_text(name);
    if (!text) return text.error();
    return parse_atmosphere(*text, std::string(name) + ".toml");
}

}  // namespace airlight
