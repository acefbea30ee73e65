// The shared text on the GPU against the same text as f32: every function, over its whole domain.

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "gpu/buffer.h"
#include "gpu/context.h"
#include "gpu/program.h"
#include "gpu/shader_text.h"
#include "gpu/texture.h"
#include "tools/point_laws.h"

using namespace airlight;
using namespace airlight::test;

namespace {

// The declarations of a law's tables.
std::string samplers_of(const PointLaw& law) {
    const auto flat = std::count_if(law.tables.begin(), law.tables.end(), [](const LawTable& t) { return t.depth == 0; });
    const auto deep = static_cast<long>(law.tables.size()) - flat;
    std::string text;
    if (flat) text += fmt::format("layout(binding = 0) uniform sampler2D t2[{}];\n", flat);
    if (deep) text += fmt::format("layout(binding = {}) uniform sampler3D t3[{}];\n", flat, deep);
    return text;
}

// A compute shader that calls one function of the text on each row of arguments.
gpu::ShaderText shader_of(const PointLaw& law) {
    const std::string text = fmt::format(R"(#version 450 core
#include "physics/readings/glsl.glsl"
#include "physics/readings/text.inc"
#include "physics/models/text.inc"
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Arguments {{ float arguments[]; }};
layout(std430, binding = 1) writeonly buffer Results {{ float results[]; }};
{2}void main() {{
    uint i = gl_GlobalInvocationID.x;
    if (i >= results.length()) return;
    float x[{0}];
    for (int k = 0; k < {0}; ++k) x[k] = arguments[{0} * i + k];
    results[i] = {1};
}}
)",
                                         law.rows[0].size(), law.call, samplers_of(law));
    return *gpu::resolve_includes(text, AIRLIGHT_SOURCE_DIR);
}

std::vector<float> on_the_gpu(const PointLaw& law) {
    const Result<gpu::Program> program = gpu::Program::compute(law.name, shader_of(law));
    if (!program) FAIL(program.error().message());
    std::vector<float> arguments;
    for (const Row& row : law.rows) arguments.insert(arguments.end(), row.begin(), row.end());
    std::vector<float> results(law.rows.size());
    const gpu::Buffer in(std::as_bytes(std::span(arguments)));
    const gpu::Buffer out(std::as_bytes(std::span(results)).size());
    in.bind_storage(0);
    out.bind_storage(1);
    std::vector<gpu::Texture> textures;
    for (const LawTable& t : law.tables) {
        textures.emplace_back(gpu::TextureSize{t.width, t.height, t.depth}, t.texels);
        textures.back().bind_sampler(static_cast<unsigned>(textures.size() - 1));
    }
    program->dispatch(static_cast<unsigned>(law.rows.size() + 63) / 64);
    out.read(std::as_writable_bytes(std::span(results)));
    return results;
}

// The largest distance in floats between the GPU's results and f32's. Results below the smallest normal float count as
// zero on both sides, because a GPU may flush them.
long largest_ulps(const PointLaw& law, const std::vector<float>& results) {
    const auto normal = [](float x) { return std::abs(x) < 0x1p-126f ? 0.0f : x; };
    long largest = 0;
    for (std::size_t i = 0; i < results.size(); ++i)
        largest = std::max(largest, ulps_between(normal(results[i]), normal(static_cast<float>(law.f32(law.rows[i])))));
    return largest;
}

// The error of the GPU's results against double, in roundings.
double roundings(PointLaw law, const std::vector<float>& results) {
    law.f32 = [i = std::size_t{0}, &results](std::span<const double>) mutable { return static_cast<double>(results[i++]); };
    return measure(law).roundings;
}

// The largest relative difference between the GPU's results and f32's.
double largest_difference(const PointLaw& law, const std::vector<float>& results) {
    double largest = 0.0;
    for (std::size_t i = 0; i < results.size(); ++i) {
        const double value = law.f32(law.rows[i]);
        largest = std::max(largest, std::abs(static_cast<double>(results[i]) - value) / std::max(std::abs(value), 1e-30));
    }
    return largest;
}

// Software renders to the bit; hardware may divide and take roots by 2.5 and 3 ulps and fuse products into sums,
// so there each rounding may count six times, and an ulp is two roundings. Its filters may weigh texels in steps of 1/256
// (OpenGL asks for no more), which moves what lies between texels by half of that for each dimension and look-up.
void check_each(const std::vector<PointLaw>& laws) {
    Result<gpu::Context> context = gpu::Context::create();
    if (!context) {
        MESSAGE("[skipped] no OpenGL: " << context.error().message());
        return;
    }
    const bool software = context->renderer().starts_with("llvmpipe");
    for (const PointLaw& law : laws) {
        CAPTURE(law.name);
        const std::vector<float> results = on_the_gpu(law);
        const long ulps = largest_ulps(law, results);
        const double error = roundings(law, results);
        fmt::print("{:<28} {:>7} points on {}: {} ulps from float, {:.3g} roundings from double\n", law.name, law.rows.size(),
                   context->renderer(), ulps, error);
        if (software) CHECK(ulps <= law.ulps);
        if (!software && !law.tables.empty()) CHECK(largest_difference(law, results) < 0x1p-6);
        else CHECK(error <= 6.0 * law.roundings + 2.0 * law.ulps);
    }
    CHECK(context->errors() == 0);
}

}  // namespace

TEST_CASE("the GPU computes rays in shells as float does") { check_each(shell_laws()); }
TEST_CASE("the GPU computes densities as float does") { check_each(density_laws()); }
TEST_CASE("the GPU computes phase functions as float does") { check_each(phase_laws()); }
TEST_CASE("the GPU computes the maps of tables as float does") { check_each(map_laws()); }
TEST_CASE("the GPU computes the models of the sky as float does") { check_each(model_laws()); }
