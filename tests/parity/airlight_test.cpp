// The model `airlight` on the GPU against the same text as f32, from the ground to the top of the air, by day and in twilight, with
// tables in textures: what a ray's nodes read of them, and the light along whole rays.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "atmosphere/presets.h"
#include "gpu/buffer.h"
#include "gpu/context.h"
#include "gpu/program.h"
#include "gpu/shader_text.h"
#include "gpu/texture.h"
#include "models/airlight_block.h"

using namespace airlight;

namespace {

gpu::Texture texture_of(const PackedTexels& table, bool deep) {
    return gpu::Texture({table.size[0], table.size[1], deep ? table.size[2] : 0}, gpu_texels(table, 0));
}

constexpr const char* shader = R"(#version 450 core
#include "physics/readings/glsl.glsl"
#include "physics/readings/text.inc"
#include "physics/models/text.inc"
layout(local_size_x = 16) in;
struct Node { float h, mu, mu_s, nu; };
struct Light { vec4 source, sunlight, ground, densities, multiple, single_air, single_aerosol, transmittance; };
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
    lights[i].source = airlight_source(source, n.h, n.mu, n.mu_s, n.nu);
    lights[i].sunlight = airlight_sunlight(transmittance, n.h, n.mu_s);
    lights[i].ground = airlight_ground(transmittance, diffuse, n.mu_s);
    AirlightDensities at = airlight_densities(densities, n.h);
    lights[i].densities = vec4(at.of[0], at.of[1], at.of[2], at.of[3]);
    AirlightLight along = airlight_light(densities, transmittance, source, diffuse, AirlightRay(n.h, n.mu, n.mu_s, n.nu, 1e30));
    lights[i].multiple = along.multiple;
    lights[i].single_air = along.single[0];
    lights[i].single_aerosol = along.single[3];
    lights[i].transmittance = along.transmittance;
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
    float multiple[gpu_wavelengths], single_air[gpu_wavelengths], single_aerosol[gpu_wavelengths], transmittance[gpu_wavelengths];
};

template <class Spectrum>
void put(const Spectrum& from, float* to) {
    std::copy(from.v, from.v + gpu_wavelengths, to);
}

Light light_at(const AirlightTables& t, const Node& node) {
    const auto number = [](float x) { return f32::Number::of(x); };
    const f32::Length h = f32::Length::of(node.h);
    const f32::Number mu = number(node.mu), mu_s = number(node.mu_s), nu = number(node.nu);
    Light light;
    put(f32::airlight_source(t.air, t.source_table(), h, mu, mu_s, nu), light.source);
    put(f32::airlight_sunlight(t.air, t.transmittance_table(), h, mu_s), light.sunlight);
    put(f32::airlight_ground(t.air, t.transmittance_table(), t.diffuse_table(), mu_s), light.ground);
    const f32::AirlightDensities densities = f32::airlight_densities(t.air, t.density_table(), h);
    for (int p = 0; p < 4; ++p) light.densities[p] = densities.of[p].value;
    const f32::AirlightLight along = t.light({h, mu, mu_s, nu, f32::Length::of(1e30f)});
    put(along.multiple, light.multiple);
    put(along.single[0], light.single_air);
    put(along.single[3], light.single_aerosol);
    put(along.transmittance, light.transmittance);
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
TEST_CASE("the GPU sees airlight as float does") {
    Result<gpu::Context> context = gpu::Context::create();
    if (!context) {
        MESSAGE("[skipped] no OpenGL: " << context.error().message());
        return;
    }
    const BakeSettings quick = {
        .sizes = {.transmittance_mu = 64, .transmittance_altitude = 32, .sun = 24, .azimuth = 4, .view = 8, .altitude = 12}, .orders = 2};
    const Tables tables = *bake_tables(*preset("earth-clear"), {400.0 * nm, 500.0 * nm, 600.0 * nm, 700.0 * nm}, quick, {});
    const AirlightTables t = airlight_tables(tables.packs()[0], 8);
    const std::vector<Node> nodes = some_nodes(t.air.top.value);

    const Result<gpu::Program> program = gpu::Program::compute("airlight", *gpu::resolve_includes(shader, AIRLIGHT_SOURCE_DIR));
    if (!program) FAIL(program.error().message());
    const gpu::Buffer air_block(airlight_block(t.air, 0)), node_block(std::as_bytes(std::span(nodes))),
        light_block(nodes.size() * sizeof(Light));
    air_block.bind_uniform(0);
    node_block.bind_storage(1);
    light_block.bind_storage(2);
    const gpu::Texture textures[] = {gpu::Texture({t.air.density_axis.texels, 2, 0}, gpu_densities(t)), texture_of(t.transmittance, false),
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
        const auto check = [&](std::initializer_list<float(Light::*)[gpu_wavelengths]> parts, double bound) {
            for (const auto part : parts) {
                const double x = difference(lights[i].*part, exact.*part);
                CHECK(x <= (context->renderer().starts_with("llvmpipe") ? bound : 0.02));
                largest = std::max(largest, x);
            }
        };
        check({&Light::source, &Light::sunlight, &Light::ground, &Light::densities}, 2e-4);
        // Distances are from the perigee: half a planet away a step of float is half a metre, of the kilometre or two of a ray that
        // passes the edge of the planet's shadow.
        check({&Light::multiple, &Light::single_air, &Light::single_aerosol, &Light::transmittance}, 1e-3);
    }
    fmt::print("  {} nodes on {}: largest difference from float {:.2g}\n", nodes.size(), context->renderer(), largest);
    CHECK(context->errors() == 0);
}
