#include "render/shaders.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>

#include "core/files.h"

namespace airlight::render {

namespace {

struct ShaderFile {
    std::string_view path, text;
};

constexpr ShaderFile shader_files[] = {
#include "shader_files.inc"
};

constexpr std::string_view shared_text = "physics/", folder_of_shaders = "src/render/shaders";

Result<std::string> read(const std::string& path) {
    if (const char* tree = std::getenv("AIRLIGHT_SHADERS"))
        return read_file(std::filesystem::path(tree) / (path.starts_with(shared_text) ? "" : folder_of_shaders) / path);
    const auto found = std::find_if(std::begin(shader_files), std::end(shader_files), [&](const ShaderFile& f) { return f.path == path; });
    if (found != std::end(shader_files)) return std::string(found->text);
    return Error{path, "no shader of this name is compiled in.", ""};
}

}  // namespace

Result<gpu::ShaderText> shader_text(std::string_view name) {
    const Result<std::string> text = read(std::string(name));
    if (!text) return text.error();
    Result<gpu::ShaderText> resolved = gpu::resolve_includes(*text, gpu::ReadText(read));
    if (!resolved) return at(name, resolved.error());
    resolved->files[0] = name;
    return resolved;
}

std::vector<std::filesystem::path> shader_folders() {
    const char* tree = std::getenv("AIRLIGHT_SHADERS");
    if (!tree) return {};
    return {std::filesystem::path(tree) / shared_text, std::filesystem::path(tree) / folder_of_shaders};
}

Result<gpu::Program> program(std::string_view vertex, std::string_view fragment, std::span<const std::string_view> defined) {
    const Result<gpu::ShaderText> first = shader_text(vertex);
    Result<gpu::ShaderText> second = shader_text(fragment);
    if (!first) return first.error();
    if (!second) return second.error();
    // After the line of the version, which is the first; those that follow keep their numbers.
    std::string definitions;
    for (const std::string_view name : defined) definitions += "#define " + std::string(name) + '\n';
    if (!defined.empty()) second->text.insert(second->text.find('\n') + 1, definitions + "#line 2 0\n");
    const gpu::Stage stages[] = {{GL_VERTEX_SHADER, *first}, {GL_FRAGMENT_SHADER, *second}};
    return gpu::Program::link(std::string(vertex) + " and " + std::string(fragment), stages);
}

Result<gpu::Program> compute_program(std::string_view name) {
    const Result<gpu::ShaderText> text = shader_text(name);
    if (!text) return text.error();
    return gpu::Program::compute(name, *text);
}

}  // namespace airlight::render
