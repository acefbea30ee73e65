#include "viewer/files.h"

#include <fmt/format.h>

#include <system_error>

namespace airlight::viewer {

std::filesystem::path free_name(const std::filesystem::path& folder, std::string_view stem, std::string_view extension) {
    for (int number = 1;; ++number) {
        std::error_code unreadable;
        const std::filesystem::path path = folder / fmt::format("{}-{:04}{}", stem, number, extension);
        if (!std::filesystem::exists(path, unreadable)) return path;
    }
}

}  // namespace airlight::viewer
