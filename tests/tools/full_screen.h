// A pass over the whole picture by a test's own fragment shader, which may include texts of src/render/shaders. Needs a context.
#pragma once

#include <epoxy/gl.h>

#include <string>
#include <string_view>

#include "gpu/vertex_array.h"
#include "render/shaders.h"
#include "tools/must.h"

namespace airlight::test {

class FullScreen {
public:
    FullScreen(std::string_view name, std::string_view fragment) : program_(must(linked(name, fragment))) {}

    // Into what is bound.
    void draw() const {
        program_.use();
        triangle_.draw_triangles(3);
    }

private:
    static Result<gpu::Program> linked(std::string_view name, std::string_view fragment) {
        const auto read = [](const std::string& path) -> Result<std::string> {
            const Result<gpu::ShaderText> file = render::shader_text(path);
            if (!file) return file.error();
            return file->text;
        };
        const gpu::Stage stages[] = {{GL_VERTEX_SHADER, must(render::shader_text("fullscreen.vert"))},
                                     {GL_FRAGMENT_SHADER, must(gpu::resolve_includes(fragment, gpu::ReadText(read)))}};
        return gpu::Program::link(name, stages);
    }

    gpu::Program program_;
    gpu::VertexArray triangle_;
};

}  // namespace airlight::test
