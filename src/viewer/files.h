// Names of files that a viewer writes.
// Uses nothing; asks the file system.
#pragma once

#include <filesystem>
#include <string_view>

namespace airlight::viewer {

// The first of stem-0001, stem-0002, ... with this extension (".png") that is not in the folder: nothing is ever overwritten.
std::filesystem::path free_name(const std::filesystem::path& folder, std::string_view stem, std::string_view extension);

// Where programs keep what should outlive them, for this one: $XDG_STATE_HOME/airlight, or else ~/.local/state/airlight; empty if the
// environment names neither.
std::filesystem::path state_folder();

}  // namespace airlight::viewer
