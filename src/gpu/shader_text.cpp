#include "gpu/shader_text.h"

#include <algorithm>
#include <set>

#include "core/files.h"

namespace airlight::gpu {

namespace {

constexpr std::string_view directive = "#include \"";

std::string_view first_line(std::string_view text) { return text.substr(0, text.find('\n')); }

Result<Done> resolve(std::string_view text, const std::filesystem::path& root, std::set<std::string>& seen, std::string& out) {
    while (!text.empty()) {
        const std::string_view line = first_line(text);
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        if (!line.starts_with(directive)) {
            out.append(line).append("\n");
            continue;
        }
        const std::string path(line.substr(directive.size(), line.rfind('"') - directive.size()));
        if (!seen.insert(path).second) continue;
        const Result<std::string> file = read_file(root / path);
        if (!file) return file.error();
        const Result<Done> done = resolve(*file, root, seen, out);
        if (!done) return done;
    }
    return Done{};
}

}  // namespace

Result<std::string> resolve_includes(std::string_view text, const std::filesystem::path& root) {
    std::set<std::string> seen;
    std::string out;
    const Result<Done> done = resolve(text, root, seen, out);
    if (!done) return done.error();
    return out;
}

}  // namespace airlight::gpu
