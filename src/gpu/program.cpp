#include "gpu/program.h"

#include <epoxy/gl.h>

#include <optional>

namespace airlight::gpu {

namespace {

struct DeleteShader {
    void operator()(unsigned name) const { glDeleteShader(name); }
};

std::string shader_log(GLuint shader) {
    GLint length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    glGetShaderInfoLog(shader, length, nullptr, log.data());
    return log;
}

std::string program_log(GLuint program) {
    GLint length = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    glGetProgramInfoLog(program, length, nullptr, log.data());
    return log;
}

// Compiles one stage and attaches it; the program keeps it alive.
std::optional<Error> attach(GLuint program, std::string_view name, const Stage& stage) {
    const Handle<DeleteShader> shader(glCreateShader(stage.type));
    const GLchar* text = stage.text.text.data();
    const auto length = static_cast<GLint>(stage.text.text.size());
    glShaderSource(shader.name(), 1, &text, &length);
    glCompileShader(shader.name());
    GLint compiled = 0;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    if (!compiled) return Error{std::string(name), "the driver refuses it:\n" + located(shader_log(shader.name()), stage.text, name), ""};
    glAttachShader(program, shader.name());
    return std::nullopt;
}

}  // namespace

void DeleteProgram::operator()(unsigned name) const { glDeleteProgram(name); }

Result<Program> Program::link(std::string_view name, std::span<const Stage> stages) {
    Program program(glCreateProgram());
    for (const Stage& stage : stages)
        if (std::optional<Error> error = attach(program.name(), name, stage)) return *error;
    glLinkProgram(program.name());
    GLint linked = 0;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    if (!linked) return Error{std::string(name), "it does not link: " + program_log(program.name()), ""};
    return program;
}

Result<Program> Program::compute(std::string_view name, const ShaderText& text) {
    const Stage stage{GL_COMPUTE_SHADER, text};
    return link(name, {&stage, 1});
}

void Program::use() const { glUseProgram(name()); }

void Program::bind_block(const char* block, unsigned binding) const {
    const GLuint index = glGetUniformBlockIndex(name(), block);
    if (index != GL_INVALID_INDEX) glUniformBlockBinding(name(), index, binding);
}

void Program::dispatch(unsigned x, unsigned y, unsigned z) const {
    use();
    glDispatchCompute(x, y, z);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

}  // namespace airlight::gpu
