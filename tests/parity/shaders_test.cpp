// Shaders from a source tree, for those who work on them: AIRLIGHT_SHADERS.

#include <doctest/doctest.h>

#include <cstdlib>

#include "core/files.h"
#include "render/shaders.h"
#include "render/tone_pass.h"
#include "tools/gpu_case.h"
#include "tools/temporary_folder.h"

using namespace airlight;
using namespace airlight::test;

namespace {

// While it lives, shaders are read from a copy of this project's.
class ShaderTree {
public:
    ShaderTree() {
        const std::filesystem::path source = AIRLIGHT_SOURCE_DIR;
        for (const char* part : {"src/render/shaders", "physics"}) {
            std::filesystem::create_directories(folder_.path / part);
            std::filesystem::copy(source / part, folder_.path / part, std::filesystem::copy_options::recursive);
        }
        setenv("AIRLIGHT_SHADERS", folder_.path.c_str(), 1);
    }
    ~ShaderTree() { unsetenv("AIRLIGHT_SHADERS"); }
    ShaderTree(const ShaderTree&) = delete;
    ShaderTree& operator=(const ShaderTree&) = delete;

    std::filesystem::path file(const char* name) const { return folder_.path / "src/render/shaders" / name; }

private:
    TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("a shader of the source tree is read anew, an error in it, or in what it includes, names the file and the line") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const ShaderTree tree;
    CHECK(render::shader_folders().size() == 2);
    CHECK(render::TonePass::create());
    const std::string main = *read_file(tree.file("tone.frag")), included = *read_file(tree.file("tone.glsl"));
    REQUIRE(write_file(tree.file("tone.frag"), "#version 450 core\nvoid main() {\n    no such thing;\n}\n"));
    const auto in_main = render::TonePass::create();
    REQUIRE(!in_main);
    INFO(in_main.error().message());
    CHECK(in_main.error().message().find("tone.frag:3") != std::string::npos);
    REQUIRE(write_file(tree.file("tone.frag"), main));
    REQUIRE(write_file(tree.file("tone.glsl"), "\n\n\nwrong\n" + included));
    const auto in_included = render::TonePass::create();
    REQUIRE(!in_included);
    INFO(in_included.error().message());
    CHECK(in_included.error().message().find("tone.glsl:") != std::string::npos);
    REQUIRE(write_file(tree.file("tone.glsl"), included));
    CHECK(render::TonePass::create());
    std::filesystem::remove(tree.file("tone.glsl"));
    const auto absent = render::TonePass::create();
    REQUIRE(!absent);
    CHECK(absent.error().message().find("tone.glsl: cannot be read") != std::string::npos);
}

TEST_CASE("without AIRLIGHT_SHADERS shaders are those that are compiled in") {
    CHECK(render::shader_folders().empty());
    CHECK(render::shader_text("tone.frag"));
    CHECK(!render::shader_text("none.frag"));
}
