// Buffers, textures, programs and their text, on the GPU or Mesa's software.

#include <doctest/doctest.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/files.h"
#include "gpu/buffer.h"
#include "gpu/context.h"
#include "gpu/program.h"
#include "gpu/shader_text.h"
#include "gpu/texture.h"

using namespace airlight;

namespace {

// A context, or a line that says why the test case is skipped.
std::optional<gpu::Context> context_or_skip() {
    Result<gpu::Context> context = gpu::Context::create();
    if (context) return std::move(*context);
    MESSAGE("[skipped] no OpenGL: " << context.error().message());
    return std::nullopt;
}

}  // namespace

TEST_CASE("a buffer reads back as it was written") {
    const std::optional<gpu::Context> context = context_or_skip();
    if (!context) return;
    const std::array<float, 5> written = {1.0f, -2.5f, 0.0f, 1e-30f, 3e38f};
    std::array<float, 5> read{};
    gpu::Buffer(std::as_bytes(std::span(written))).read(std::as_writable_bytes(std::span(read)));
    CHECK(read == written);
    CHECK(context->errors() == 0);
}

TEST_CASE("a texture reads back as it was written, flat and deep") {
    const std::optional<gpu::Context> context = context_or_skip();
    if (!context) return;
    for (const gpu::TextureSize size : {gpu::TextureSize{3, 2}, gpu::TextureSize{3, 2, 5}}) {
        std::vector<float> written(static_cast<std::size_t>(4 * size.width * size.height * std::max(1, size.depth)));
        for (std::size_t i = 0; i < written.size(); ++i) written[i] = static_cast<float>(i) * 0.37f;
        std::vector<float> read(written.size());
        gpu::Texture(size, written).read(read);
        CHECK(read == written);
    }
    CHECK(context->errors() == 0);
}

TEST_CASE("a texture is linear between the centres of its texels") {
    const std::optional<gpu::Context> context = context_or_skip();
    if (!context) return;
    const Result<gpu::Program> program = gpu::Program::compute("linear.comp", R"(#version 450 core
layout(local_size_x = 1) in;
layout(binding = 0) uniform sampler2D table;
layout(std430, binding = 0) buffer Results { vec4 result; };
void main() { result = textureLod(table, vec2((0.5 + 0.25) / 2.0, 0.5), 0.0); }
)");
    REQUIRE(program);
    const std::array<float, 8> texels = {0.0f, 1.0f, 2.0f, 3.0f, 4.0f, 4.0f, 4.0f, 4.0f};
    const gpu::Texture table({2, 1}, texels);
    const gpu::Buffer out(16);
    table.bind_sampler(0);
    out.bind_storage(0);
    program->dispatch(1);
    std::array<float, 4> read{};
    out.read(std::as_writable_bytes(std::span(read)));
    // A quarter of the way from the first texel to the second. Hardware may keep 8 bits of the weight: 1/512 of the step.
    for (std::size_t i = 0; i < 4; ++i) CHECK(std::abs(read[i] - (0.75f * texels[i] + 0.25f * texels[i + 4])) <= 4.0f / 512.0f);
}

TEST_CASE("a shader that the driver refuses is an error with the driver's words") {
    const std::optional<gpu::Context> context = context_or_skip();
    if (!context) return;
    const Result<gpu::Program> program = gpu::Program::compute("broken.comp", "#version 450 core\nvoid main() { undeclared = 1.0; }\n");
    REQUIRE(!program);
    CHECK(program.error().message().find("broken.comp") != std::string::npos);
    CHECK(program.error().message().find("undeclared") != std::string::npos);
}

TEST_CASE("a file that shaders include is taken once, and a missing one is named") {
    const std::filesystem::path root = std::filesystem::temp_directory_path() / ("airlight_gpu_test_" + std::to_string(getpid()));
    std::filesystem::create_directories(root);
    REQUIRE(write_file(root / "a.glsl", "#include \"b.glsl\"\nfloat a;\n"));
    REQUIRE(write_file(root / "b.glsl", "float b;\n"));
    CHECK(*gpu::resolve_includes("#version 450\n#include \"a.glsl\"\n#include \"b.glsl\"\nend", root) ==
          "#version 450\nfloat b;\nfloat a;\nend\n");
    const Result<std::string> missing = gpu::resolve_includes("#include \"c.glsl\"", root);
    REQUIRE(!missing);
    CHECK(missing.error().message().find("c.glsl") != std::string::npos);
    std::filesystem::remove_all(root);
}
