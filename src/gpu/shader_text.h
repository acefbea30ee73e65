// A shader's text with its #include lines replaced by the files they name, and the way back from a driver's message to their lines.
// Uses core; needs no GPU.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace airlight::gpu {

struct ShaderText {
    ShaderText(const char* plain) : text(plain) {}
    ShaderText(std::string plain) : text(std::move(plain)) {}

    // What the compiler reads. Lines "#line 12 3" say that line 12 of files[3] follows; 0 is the shader's own text, which may have no name.
    std::string text;
    std::vector<std::string> files = {""};
};

// `text` with each line `#include "path"` replaced by the file at root/path, itself so treated.
// A file is taken once, at its first mention, as a header with an include guard is.
// Fails, naming it and the line that asks for it, if a file cannot be read.
Result<ShaderText> resolve_includes(std::string_view text, const std::filesystem::path& root);

// The same with files that come from elsewhere: `read` gives the text of a path.
using ReadText = std::function<Result<std::string>(const std::string& path)>;
Result<ShaderText> resolve_includes(std::string_view text, const ReadText& read);

// A driver's message with the numbers of files, "3:12(8)" (Mesa) or "3(12)" (NVIDIA), replaced by names: "physics/shell.glsl:12".
// The shader's own text is called `name` if files[0] is empty.
std::string located(std::string_view message, const ShaderText& shader, std::string_view name);

}  // namespace airlight::gpu
