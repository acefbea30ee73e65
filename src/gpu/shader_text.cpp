#include "gpu/shader_text.h"

#include <algorithm>
#include <regex>

#include "core/files.h"

namespace airlight::gpu {

namespace {

constexpr std::string_view directive = "#include \"";

std::string_view first_line(std::string_view text) { return text.substr(0, text.find('\n')); }

std::string line_directive(int line, std::size_t file) { return "#line " + std::to_string(line) + ' ' + std::to_string(file) + '\n'; }

std::string place(const ShaderText& shader, std::size_t file, int line) {
    return file ? shader.files[file] + ':' + std::to_string(line) : "line " + std::to_string(line);
}

Result<Done> resolve(std::string_view text, std::size_t file, const ReadText& read, ShaderText& out);

Result<Done> include(const std::string& path, const ReadText& read, ShaderText& out) {
    if (std::find(out.files.begin(), out.files.end(), path) != out.files.end()) return Done{};
    const Result<std::string> text = read(path);
    if (!text) return text.error();
    out.files.push_back(path);
    const std::size_t file = out.files.size() - 1;
    out.text += line_directive(1, file);
    return resolve(*text, file, read, out);
}

Result<Done> resolve(std::string_view text, std::size_t file, const ReadText& read, ShaderText& out) {
    for (int number = 1; !text.empty(); ++number) {
        const std::string_view line = first_line(text);
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        if (!line.starts_with(directive)) {
            out.text.append(line).append("\n");
            continue;
        }
        const Result<Done> done = include(std::string(line.substr(directive.size(), line.rfind('"') - directive.size())), read, out);
        if (!done) return at(place(out, file, number), done.error());
        out.text += line_directive(number + 1, file);
    }
    return Done{};
}

}  // namespace

Result<ShaderText> resolve_includes(std::string_view text, const std::filesystem::path& root) {
    return resolve_includes(text, [&](const std::string& path) { return read_file(root / path); });
}

Result<ShaderText> resolve_includes(std::string_view text, const ReadText& read) {
    ShaderText out("");
    const Result<Done> done = resolve(text, 0, read, out);
    if (!done) return done.error();
    return out;
}

std::string located(std::string_view message, const ShaderText& shader, std::string_view name) {
    static const std::regex place_of(R"(^(\d+)(?::(\d+)\(\d+\)|\((\d+)\) ?))");
    std::string out;
    while (!message.empty()) {
        std::string line(first_line(message));
        message.remove_prefix(std::min(line.size() + 1, message.size()));
        std::smatch found;
        if (std::regex_search(line, found, place_of)) {
            const std::size_t file = std::stoul(found[1]);
            const bool named = file < shader.files.size() && !shader.files[file].empty();
            const std::string where = named ? shader.files[file] : std::string(name);
            line = where + ':' + (found[2].matched ? found[2] : found[3]).str() + found.suffix().str();
        }
        out.append(line).append("\n");
    }
    return out;
}

}  // namespace airlight::gpu
