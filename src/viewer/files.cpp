#include "viewer/files.h"

#include <fmt/format.h>

#include <cstdlib>
#include <system_error>

namespace airlight::viewer {

std::filesystem::path free_name(const std::filesystem::path& folder, std::string_view stem, std::string_view extension) {
    for (int number = 1;; ++number) {
        std::error_code unreadable;
        const std::filesystem::path path = folder / fmt::format("{}-{:04}{}", stem, number, extension);
        if (!std::filesystem::exists(path, unreadable)) return path;
    }
}

std::filesystem::path state_folder() {
    // The XDG base directory specification: a path that is not absolute is to be ignored.
    const char* state = std::getenv("XDG_STATE_HOME");
    if (state != nullptr && std::filesystem::path(state).is_absolute()) return std::filesystem::path(state) / "airlight";
    const char* home = std::getenv("HOME");
    return home != nullptr && *home != '\0' ? std::filesystem::path(home) / ".local/state/airlight" : std::filesystem::path();
}

}  // namespace airlight::viewer
