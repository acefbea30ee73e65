// A linked shader program.
// Uses core; knows no physics.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/result.h"
#include "gpu/handle.h"
#include "gpu/shader_text.h"

namespace airlight::gpu {

struct DeleteProgram {
    void operator()(unsigned name) const;
};

// One stage: GL_COMPUTE_SHADER, GL_VERTEX_SHADER or GL_FRAGMENT_SHADER, and its whole text.
struct Stage {
    unsigned type;
    ShaderText text;
};

class Program {
public:
    // Compiles and links. Fails with the driver's own messages, each with the file and the line that it is about;
    // the shaders' own text is called `name` ("sky.frag").
    static Result<Program> link(std::string_view name, std::span<const Stage> stages);
    static Result<Program> compute(std::string_view name, const ShaderText& text);

    void use() const;

    // Where the uniform block `block` is read from, if the text has it and names no binding itself.
    void bind_block(const char* block, unsigned binding) const;

    // Runs a compute program on this many work groups, and makes what it wrote visible to what follows.
    void dispatch(unsigned x, unsigned y = 1, unsigned z = 1) const;

    unsigned name() const { return handle_.name(); }

private:
    explicit Program(unsigned name) : handle_(name) {}
    Handle<DeleteProgram> handle_;
};

}  // namespace airlight::gpu
