// The programs of this module's passes, from texts that are compiled in (src/render/shaders and the shared text of physics/).
// Uses gpu.
#pragma once

#include <initializer_list>
#include <string_view>

#include "gpu/program.h"

namespace airlight::render {

// The text of a file of src/render/shaders, with what it includes: "terrain.vert".
Result<gpu::ShaderText> shader_text(std::string_view name);

// A program of a vertex and a fragment shader: program("terrain.vert", "terrain.frag").
Result<gpu::Program> program(std::string_view vertex, std::string_view fragment);

// A program of a compute shader: compute_program("histogram.comp").
Result<gpu::Program> compute_program(std::string_view name);

}  // namespace airlight::render
