// Objects of a scene, read from its file. Uses toml.
#pragma once

#include <filesystem>
#include <vector>

#include "scene/object_scene.h"
#include "toml/toml_input.h"

namespace airlight {

// The blocks [[object]] of a scene; paths in them are relative to `folder`.
std::vector<ObjectScene> read_objects(TomlInput& file, const std::filesystem::path& folder);

}  // namespace airlight
