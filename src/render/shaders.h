// The programs of this module's passes, from texts that are compiled in (src/render/shaders and the shared text of physics/). For those
// who work on them: if the environment variable AIRLIGHT_SHADERS names a tree of this project's source, they are read from there, each
// time that a program is made.
// Uses core and gpu.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

#include "gpu/program.h"

namespace airlight::render {

// The text of a file of src/render/shaders, with what it includes: "terrain.vert".
Result<gpu::ShaderText> shader_text(std::string_view name);

// The folders that AIRLIGHT_SHADERS has shader_text() read from; none without it.
std::vector<std::filesystem::path> shader_folders();

// A program of a vertex and a fragment shader: program("terrain.vert", "terrain.frag"). `defined`: names that the fragment shader's text
// finds defined.
Result<gpu::Program> program(std::string_view vertex, std::string_view fragment, std::span<const std::string_view> defined = {});

// A program of a compute shader: compute_program("histogram.comp").
Result<gpu::Program> compute_program(std::string_view name);

}  // namespace airlight::render
