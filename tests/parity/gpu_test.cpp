// Buffers, textures, programs and their text, on the GPU or Mesa's software.

#include <doctest/doctest.h>
#include <epoxy/gl.h>

#include <array>
#include <filesystem>
#include <limits>
#include <vector>

#include "core/files.h"
#include "gpu/buffer.h"
#include "gpu/context.h"
#include "gpu/framebuffer.h"
#include "gpu/pass_timers.h"
#include "gpu/program.h"
#include "gpu/sampler.h"
#include "gpu/shader_text.h"
#include "gpu/texture.h"
#include "gpu/vertex_array.h"
#include "tools/gpu_case.h"
#include "tools/temporary_folder.h"

using namespace airlight;
using namespace airlight::test;

TEST_CASE("a buffer reads back as it was written") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const std::array<float, 5> written = {1.0f, -2.5f, 0.0f, 1e-30f, 3e38f};
    std::array<float, 5> read{};
    gpu::Buffer(std::as_bytes(std::span(written))).read(std::as_writable_bytes(std::span(read)));
    CHECK(read == written);
}

TEST_CASE("a texture reads back as it was written, flat and deep") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    for (const gpu::TextureSize size : {gpu::TextureSize{3, 2}, gpu::TextureSize{3, 2, 5}}) {
        std::vector<float> written(static_cast<std::size_t>(4 * size.width * size.height * std::max(1, size.depth)));
        for (std::size_t i = 0; i < written.size(); ++i) written[i] = static_cast<float>(i) * 0.37f;
        std::vector<float> read(written.size());
        gpu::Texture(size, written).read(read);
        CHECK(read == written);
    }
}

TEST_CASE("a texture is linear between the centres of its texels") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
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

TEST_CASE("a texture of every format reads back as it was written, within its rounding") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    using F = gpu::TextureFormat;
    const std::pair<F, float> formats[] = {{F::rgba32f, 0.0f},        {F::rgba16f, 0x1p-11f},  {F::rgba8, 0.5f / 255.0f},
                                           {F::srgb8, 1.0f / 255.0f}, {F::rg8, 0.5f / 255.0f}, {F::rg16, 0.5f / 65535.0f},
                                           {F::r32f, 0.0f},           {F::depth32f, 0.0f},     {F::depth24, 0x1p-24f}};
    for (const auto& f : formats) {
        const F format = f.first;
        const float rounding = f.second;
        CAPTURE(static_cast<int>(format));
        std::vector<float> written;
        for (int i = 0; i < 6 * gpu::channels(format); ++i) written.push_back(static_cast<float>(i) / 24.0f);
        std::vector<float> read(written.size());
        gpu::Texture({3, 2}, written, format).read(read);
        for (std::size_t i = 0; i < read.size(); ++i) CHECK(std::abs(read[i] - written[i]) <= rounding * 1.001f);
    }
}

namespace {

// A triangle over the left half of the picture, nearer to the right in depth, in the colour of its vertices.
constexpr const char* half_vertex = R"(#version 450 core
layout(location = 0) in vec2 place;
layout(location = 1) in vec3 colour;
layout(location = 0) out vec3 seen;
void main() { gl_Position = vec4(place, 0.25, 1.0); seen = colour; }
)";
constexpr const char* half_fragment = R"(#version 450 core
layout(location = 0) in vec3 seen;
layout(location = 0) out vec4 first;
layout(location = 1) out vec2 second;
void main() { first = vec4(seen, 1.0); second = gl_FragCoord.xy; }
)";

}  // namespace

TEST_CASE("a pass draws into all textures of its framebuffer, and leaves the rest as cleared") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    using F = gpu::TextureFormat;
    const gpu::Texture first({8, 4}), second({8, 4}, {}, F::rgba16f), depth({8, 4}, {}, F::depth32f);
    const Result<gpu::Framebuffer> target = gpu::Framebuffer::create({&first, &second}, &depth);
    REQUIRE(target);
    const gpu::Stage stages[] = {{GL_VERTEX_SHADER, half_vertex}, {GL_FRAGMENT_SHADER, half_fragment}};
    const Result<gpu::Program> program = gpu::Program::link("half", stages);
    REQUIRE(program);
    constexpr float r = 0.5f, g = 0.25f, b = 0.75f;
    const std::array<float, 30> corners = {-1, -1, r, g, b, 0, -1, r, g, b, -1, 1, r, g, b, 0, -1, r, g, b, 0, 1, r, g, b, -1, 1, r, g, b};
    const gpu::Buffer vertices(std::as_bytes(std::span(corners)));
    const gpu::VertexArray array(vertices, 5 * sizeof(float), {{0, 2, 0}, {1, 3, 2 * sizeof(float)}});
    target->clear_colour(0, 0.0f, 0.0f, 0.0f, 0.0f);
    target->clear_colour(1, -1.0f, -1.0f, 0.0f, 0.0f);
    target->clear_depth(0.0f);
    target->bind();
    program->use();
    array.draw_triangles(6);
    std::vector<float> colours(4 * 8 * 4), places(4 * 8 * 4);
    first.read(colours);
    second.read(places);
    for (std::size_t y = 0; y < 4; ++y)
        for (std::size_t x = 0; x < 8; ++x) {
            const float* colour = &colours[4 * (8 * y + x)];
            CHECK(colour[0] == (x < 4 ? r : 0.0f));
            CHECK(colour[2] == (x < 4 ? b : 0.0f));
            CHECK(places[4 * (8 * y + x)] == (x < 4 ? static_cast<float>(x) + 0.5f : -1.0f));
        }
}

TEST_CASE("a buffer is written in its middle, and a sampler repeats or clamps") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    std::array<float, 4> values = {1.0f, 2.0f, 3.0f, 4.0f};
    const gpu::Buffer buffer(std::as_bytes(std::span(values)));
    buffer.write(std::as_bytes(std::span(values).first(2)), 4);
    buffer.read(std::as_writable_bytes(std::span(values)));
    CHECK(values == std::array<float, 4>{1.0f, 1.0f, 2.0f, 4.0f});

    const Result<gpu::Program> program = gpu::Program::compute("beyond.comp", R"(#version 450 core
layout(local_size_x = 1) in;
layout(binding = 0) uniform sampler2D table;
layout(std430, binding = 0) buffer Results { vec4 result; };
void main() { result = textureLod(table, vec2(1.25, 0.5), 0.0); }
)");
    REQUIRE(program);
    const std::array<float, 8> texels = {1.0f, 1.0f, 1.0f, 1.0f, 2.0f, 2.0f, 2.0f, 2.0f};
    const gpu::Texture table({2, 1}, texels);
    const gpu::Buffer out(16);
    table.bind_sampler(0);
    out.bind_storage(0);
    for (const auto& [wrap, expected] : {std::pair{gpu::Wrap::repeat, 1.0f}, std::pair{gpu::Wrap::clamp, 2.0f}}) {
        const gpu::Sampler sampler(gpu::Filter::nearest, wrap);
        sampler.bind(0);
        program->dispatch(1);
        gpu::Sampler::unbind(0);
        out.read(std::as_writable_bytes(std::span(values)));
        CHECK(values[0] == expected);
    }
}

TEST_CASE("the times of passes are those of the GPU, and one that does more takes longer") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const Result<gpu::Program> program = gpu::Program::compute("sum.comp", R"(#version 450 core
layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer Results { uint result; };
void main() {
    uint x = result;
    for (uint i = 0u; i < 100000u; ++i) x = x * 1664525u + 1013904223u;
    result = x;
}
)");
    REQUIRE(program);
    const gpu::Buffer out(4);
    out.bind_storage(0);
    program->dispatch(1);  // compiled and warm
    gpu::PassTimers timers;
    {
        const auto both = timers.time("both");
        {
            const auto once = timers.time("once");
            program->dispatch(1);
        }
        const auto often = timers.time("often");
        for (int i = 0; i < 20; ++i) program->dispatch(1);
    }
    const std::vector<gpu::PassTime> times = timers.read();
    REQUIRE(times.size() == 3);
    CHECK(times[0].pass == "both");
    CHECK(times[1].milliseconds > 0.0);
    CHECK(times[2].milliseconds > times[1].milliseconds);
    CHECK(times[0].milliseconds >= times[2].milliseconds);
    CHECK(timers.read().empty());
}

TEST_CASE("a shader that the driver refuses is an error with the driver's words, the file and the line") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const Result<gpu::Program> program = gpu::Program::compute("broken.comp", "#version 450 core\nvoid main() { undeclared = 1.0; }\n");
    REQUIRE(!program);
    CHECK(program.error().message().find("broken.comp:2") != std::string::npos);
    CHECK(program.error().message().find("undeclared") != std::string::npos);

    gpu::ShaderText included("#version 450 core\n#line 1 1\n\nfloat wrong() { return undeclared; }\n#line 3 0\nvoid main() {}\n");
    included.files.push_back("physics/wrong.glsl");
    const Result<gpu::Program> other = gpu::Program::compute("broken.comp", included);
    REQUIRE(!other);
    CHECK(other.error().message().find("physics/wrong.glsl:2") != std::string::npos);
}

TEST_CASE("messages of Mesa and of NVIDIA name the file that they are about") {
    gpu::ShaderText shader("");
    shader.files.push_back("physics/shell.glsl");
    CHECK(gpu::located("1:12(8): error: no\n", shader, "sky.frag") == "physics/shell.glsl:12: error: no\n");
    CHECK(gpu::located("1(12) : error C1: no", shader, "sky.frag") == "physics/shell.glsl:12: error C1: no\n");
    CHECK(gpu::located("0:3(1): error: no\nmore 0:3(1)\n", shader, "sky.frag") == "sky.frag:3: error: no\nmore 0:3(1)\n");
    CHECK(gpu::located("7:3(1): error", shader, "sky.frag") == "sky.frag:3: error\n");
}

TEST_CASE("a limit of the driver that is too low, and a lost context, are one clear message") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const gpu::Limit impossible = {GL_MAX_TEXTURE_SIZE, std::numeric_limits<int>::max(), "texels along a side"};
    const Result<Done> checked = gpu::check_limits({&impossible, 1});
    REQUIRE(!checked);
    CHECK(checked.error().message().find("texels along a side; 2147483647 are needed") != std::string::npos);
    CHECK(gpu::lost_context(GL_GUILTY_CONTEXT_RESET).message().find("a shader of this program") != std::string::npos);
    CHECK(gpu::lost_context(GL_INNOCENT_CONTEXT_RESET).message().find("another program") != std::string::npos);
}

TEST_CASE("what the driver calls an error or a slow path is counted") {
    Result<gpu::Context> context = gpu::Context::create();
    if (!context) {
        MESSAGE("[skipped] no OpenGL: " << context.error().message());
        return;
    }
    CHECK(context->errors() == 0);
    glEnable(GL_TEXTURE_2D + 12345);  // no such thing
    CHECK(context->errors() == 1);
    const auto insert = [](GLenum type, GLenum severity) {
        glDebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, type, 1, severity, -1, "from a test");
    };
    insert(GL_DEBUG_TYPE_PERFORMANCE, GL_DEBUG_SEVERITY_MEDIUM);
    CHECK(context->errors() == 2);
    insert(GL_DEBUG_TYPE_PERFORMANCE, GL_DEBUG_SEVERITY_NOTIFICATION);
    insert(GL_DEBUG_TYPE_MARKER, GL_DEBUG_SEVERITY_HIGH);
    CHECK(context->errors() == 2);
}

// Run by a test of its own (CMakeLists.txt), with Mesa told to offer less.
TEST_CASE("an old driver is one clear message" * doctest::skip()) {
    const Result<gpu::Context> context = gpu::Context::create();
    REQUIRE(!context);
    CHECK(context.error().message().find("does not offer OpenGL 4.5 core") != std::string::npos);
    CHECK(context.error().message().find("libgl1-mesa-dri") != std::string::npos);
}

TEST_CASE("a file that shaders include is taken once, its lines keep their numbers, and a missing one is named") {
    const TemporaryFolder folder;
    const std::filesystem::path root = folder.path;
    REQUIRE(write_file(root / "a.glsl", "#include \"b.glsl\"\nfloat a;\n"));
    REQUIRE(write_file(root / "b.glsl", "float b;\n"));
    const Result<gpu::ShaderText> shader = gpu::resolve_includes("#version 450\n#include \"a.glsl\"\n#include \"b.glsl\"\nend", root);
    REQUIRE(shader);
    CHECK(shader->text == "#version 450\n#line 1 1\n#line 1 2\nfloat b;\n#line 2 1\nfloat a;\n#line 3 0\n#line 4 0\nend\n");
    CHECK(shader->files == std::vector<std::string>{"", "a.glsl", "b.glsl"});
    REQUIRE(write_file(root / "d.glsl", "\n#include \"c.glsl\"\n"));
    const Result<gpu::ShaderText> missing = gpu::resolve_includes("#include \"d.glsl\"", root);
    REQUIRE(!missing);
    CHECK(missing.error().message().find("d.glsl:2") != std::string::npos);
    CHECK(missing.error().message().find("c.glsl") != std::string::npos);
}
