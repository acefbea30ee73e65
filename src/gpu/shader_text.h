// A shader's text with its #include lines replaced by the files they name.
// Uses core; needs no GPU.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/result.h"

namespace airlight::gpu {

// `text` with each line `#include "path"` replaced by the file at root/path, itself so treated.
// A file is taken once, at its first mention, as a header with an include guard is.
// Fails, naming it, if a file cannot be read.
Result<std::string> resolve_includes(std::string_view text, const std::filesystem::path& root);

}  // namespace airlight::gpu
