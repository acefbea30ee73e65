// The tables of the model `airlight` on the GPU against the same text as f32: what a ray's nodes read of them, from the ground to
// the top of the air, by day and in twilight, with tables in textures.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "atmosphere/presets.h"
#include "gpu/buffer.h"
#include "gpu/context.h"
#include "gpu/program.h"
#include "gpu/shader_text.h"
#include "gpu/texture.h"
#include "models/airlight_tables.h"

using namespace airlight;

namespace {

constexpr int gpu_wavelengths = 4;

// The bytes of a std430 block: scalars stand at multiples of four bytes, spectra of four wavelengths at multiples of sixteen.
class Block {
public:
    void put(int x) { append(&x, sizeof(x)); }
    void put(float x) { append(&x, sizeof(x)); }
    template <class R, int N, int L, int W, int S, int P>
    void put(const Spectral<R, N, L, W, S, P>& x) {
        align();
        append(x.v, gpu_wavelengths * sizeof(float));
    }
    template <class R, int L, int W, int S, int P>
    void put(Quantity<R, L, W, S, P> x) {
        put(x.value);
    }
    template <class T, std::size_t count>
    void put(const T (&array)[count]) {
        for (const T& x : array) put(x);
    }
    void put(const f32::AirlightAxis& x) {
        put(x.segments), put(x.texels), put(x.from), put(x.inverse_range), put(x.first), put(x.last), put(x.crowds);
    }
    // A structure that holds a spectrum ends at a multiple of sixteen.
    void align() { bytes_.resize((bytes_.size() + 15) / 16 * 16); }
    std::span<const std::byte> bytes() const { return bytes_; }

private:
    void append(const void* from, std::size_t size) {
        const std::size_t at = bytes_.size();
        bytes_.resize(at + size);
        std::memcpy(bytes_.data() + at, from, size);
    }
    std::vector<std::byte> bytes_;
};

Block block_of(const f32::AirlightAir& air) {
    Block b;
    b.put(air.bottom), b.put(air.top), b.put(air.parts);
    b.put(air.scattering), b.put(air.extinction), b.put(air.opacity);
    b.put(air.ground_albedo), b.put(air.solar_irradiance), b.put(air.sun_radius);
    b.put(air.density_axis), b.put(air.transmittance_axis), b.put(air.source_axis);
    b.put(air.deepest_depth), b.put(air.log_low), b.put(air.log_range);
    b.put(air.sun_texels), b.put(air.azimuth_texels), b.put(air.view_texels), b.put(air.cosine_texels);
    b.align();
    return b;
}

gpu::Texture texture_of(const PackedTexels& table, bool deep) {
    std::vector<float> texels;
    for (std::size_t i = 0; i < table.values.size(); i += pack_size)
        for (std::size_t w = 0; w < gpu_wavelengths; ++w) texels.push_back(static_cast<float>(table.values[i + w]) / 65535.0f);
    return gpu::Texture({table.size[0], table.size[1], deep ? table.size[2] : 0}, texels);
}

gpu::Texture texture_of(const std::vector<f32::Spectrum>& rows, int width) {
    std::vector<float> texels;
    for (const f32::Spectrum& row : rows) texels.insert(texels.end(), row.v, row.v + gpu_wavelengths);
    return gpu::Texture({width, static_cast<int>(rows.size()) / width, 0}, texels);
}

constexpr const char* shader = R"(#version 450 core
#include "physics/readings/glsl.glsl"
#include "physics/readings/text.inc"
#include "physics/models/text.inc"
layout(local_size_x = 16) in;
layout(std430, binding = 0) readonly buffer Air { AirlightAir air; };
struct Node { float h, mu, mu_s, nu; };
struct Light { vec4 source, sunlight, ground, densities; };
layout(std430, binding = 1) readonly buffer Nodes { Node nodes[]; };
layout(std430, binding = 2) writeonly buffer Lights { Light lights[]; };
layout(binding = 0) uniform sampler2D densities;
layout(binding = 1) uniform sampler2D transmittance;
layout(binding = 2) uniform sampler3D source;
layout(binding = 3) uniform sampler2D diffuse;
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= nodes.length()) return;
    Node n = nodes[i];
    lights[i].source = airlight_source(air, source, n.h, n.mu, n.mu_s, n.nu);
    lights[i].sunlight = airlight_sunlight(air, transmittance, n.h, n.mu_s);
    lights[i].ground = airlight_ground(air, transmittance, diffuse, n.mu_s);
    AirlightDensities at = airlight_densities(air, densities, n.h);
    lights[i].densities = vec4(at.of[0], at.of[1], at.of[2], at.of[3]);
}
)";

struct Node {
    float h, mu, mu_s, nu;
};

// From the ground to the top of the air, not on an edge of a layer; towards all sides.
std::vector<Node> some_nodes(float top_m) {
    std::vector<Node> nodes;
    for (const double altitude : {0.0, 0.003, 0.015, 0.09, 0.4, 0.97})
        for (const double zenith_deg : {3.0, 60.0, 88.0, 95.0, 150.0})
            for (const double sun_deg : {10.0, 60.0, 88.0, 93.0, 97.0})
                for (const double azimuth : {0.1, 1.0, 3.0}) {
                    const double mu = std::cos(zenith_deg * deg), mu_s = std::cos(sun_deg * deg);
                    const double nu = mu * mu_s + std::sin(zenith_deg * deg) * std::sin(sun_deg * deg) * std::cos(azimuth);
                    nodes.push_back(
                        {static_cast<float>(altitude) * top_m, static_cast<float>(mu), static_cast<float>(mu_s), static_cast<float>(nu)});
                }
    return nodes;
}

struct Light {
    float source[gpu_wavelengths], sunlight[gpu_wavelengths], ground[gpu_wavelengths], densities[gpu_wavelengths];
};

Light light_at(const AirlightTables& t, const Node& node) {
    const auto number = [](float x) { return f32::Number::of(x); };
    const f32::Length h = f32::Length::of(node.h);
    const f32::Spectrum source = f32::airlight_source(t.air, t.source_table(), h, number(node.mu), number(node.mu_s), number(node.nu)),
                        sunlight = f32::airlight_sunlight(t.air, t.transmittance_table(), h, number(node.mu_s));
    const f32::RadianceSpectrum ground = f32::airlight_ground(t.air, t.transmittance_table(), t.diffuse_table(), number(node.mu_s));
    const f32::AirlightDensities densities = f32::airlight_densities(t.air, t.density_table(), h);
    Light light;
    for (int w = 0; w < gpu_wavelengths; ++w) {
        light.source[w] = source.v[w];
        light.sunlight[w] = sunlight.v[w];
        light.ground[w] = ground.v[w];
        light.densities[w] = densities.of[w].value;
    }
    return light;
}

// The largest difference relative to the greatest of the wavelengths: what is a millionth of it is nothing that an eye could see.
double difference(const float* gpu, const float* cpu) {
    double largest = 0.0, scale = 1e-30;
    for (int w = 0; w < gpu_wavelengths; ++w) {
        largest = std::max(largest, std::abs(static_cast<double>(gpu[w]) - static_cast<double>(cpu[w])));
        scale = std::max(scale, std::abs(static_cast<double>(cpu[w])));
    }
    return largest / scale;
}

}  // namespace

// Software renders with float's own arithmetic, but filters in another order and takes exponentials and roots of its own: in
// exponents of some tens a few roundings are 1e-5. Hardware filters with few bits of weight: 1/256 of a texel's step.
TEST_CASE("the GPU reads airlight's tables as float does") {
    Result<gpu::Context> context = gpu::Context::create();
    if (!context) {
        MESSAGE("[skipped] no OpenGL: " << context.error().message());
        return;
    }
    const BakeSettings quick = {
        .sizes = {.transmittance_mu = 64, .transmittance_altitude = 32, .sun = 24, .azimuth = 4, .view = 8, .altitude = 12}, .orders = 2};
    const Tables tables = *bake_tables(*preset("earth-clear"), {400.0 * nm, 500.0 * nm, 600.0 * nm, 700.0 * nm}, quick, {});
    const AirlightTables t = airlight_tables(tables.packs()[0]);
    const std::vector<Node> nodes = some_nodes(t.air.top.value);

    const Result<gpu::Program> program = gpu::Program::compute("airlight", *gpu::resolve_includes(shader, AIRLIGHT_SOURCE_DIR));
    if (!program) FAIL(program.error().message());
    const gpu::Buffer air_block(block_of(t.air).bytes()), node_block(std::as_bytes(std::span(nodes))),
        light_block(nodes.size() * sizeof(Light));
    air_block.bind_storage(0);
    node_block.bind_storage(1);
    light_block.bind_storage(2);
    const gpu::Texture textures[] = {texture_of(t.densities, t.air.density_axis.texels), texture_of(t.transmittance, false),
                                     texture_of(t.source, true), texture_of(t.diffuse, false)};
    for (unsigned i = 0; i < 4; ++i) textures[i].bind_sampler(i);
    program->dispatch(static_cast<unsigned>(nodes.size() + 15) / 16);
    std::vector<Light> lights(nodes.size());
    light_block.read(std::as_writable_bytes(std::span(lights)));

    double largest = 0.0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Light exact = light_at(t, nodes[i]);
        CAPTURE(nodes[i].h);
        CAPTURE(nodes[i].mu);
        CAPTURE(nodes[i].mu_s);
        for (const double x : {difference(lights[i].source, exact.source), difference(lights[i].sunlight, exact.sunlight),
                               difference(lights[i].ground, exact.ground), difference(lights[i].densities, exact.densities)}) {
            CHECK(x <= (context->renderer().starts_with("llvmpipe") ? 2e-4 : 0.02));
            largest = std::max(largest, x);
        }
    }
    fmt::print("  {} nodes on {}: largest difference from float {:.2g}\n", nodes.size(), context->renderer(), largest);
    CHECK(context->errors() == 0);
}
