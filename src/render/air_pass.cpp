#include "render/air_pass.h"

#include <epoxy/gl.h>

#include <array>
#include <cassert>
#include <utility>

#include "models/airlight_block.h"
#include "render/shaders.h"

namespace airlight::render {

namespace {

using Four = std::array<float, 4>;

// On a piece of a ray. tests/parity/air_pass_test.cpp: within 1.1 % of twelve from space at sunset, 0.4 % elsewhere.
constexpr int nodes_per_piece = 8;

constexpr unsigned air_binding = 1, view_binding = 2, colours_binding = 3;

Four four(Vec3 v, double w) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), static_cast<float>(w)}; }

gpu::Texture texture_of(const PackedTexels& table, bool deep, int first) {
    return gpu::Texture({table.size[0], table.size[1], deep ? table.size[2] : 0}, gpu_texels(table, first));
}

gpu::Texture texture_of(const PackPhases& phases, int first) {
    const std::vector<float> texels = gpu_phases(phases, first);
    const int row = 4 * f32::airlight_parts;
    return gpu::Texture({static_cast<int>(texels.size()) / row, f32::airlight_parts}, texels);
}

// `uniform AirColours`: the colour of each wavelength, then the two coefficients of limb darkening.
std::array<Four, 6> colours_of(const AirOptics& optics, int first, std::span<const Vec3> colours) {
    std::array<Four, 6> block{};
    for (int w = 0; w < gpu_wavelengths; ++w) {
        const auto i = static_cast<std::size_t>(w), at = static_cast<std::size_t>(first + w);
        if (at < colours.size()) block[i] = four(colours[at], 0.0);
        block[4][i] = static_cast<float>(optics.sun.limb_darkening_1.at(optics.wavelengths[at]).value);
        block[5][i] = static_cast<float>(optics.sun.limb_darkening_2.at(optics.wavelengths[at]).value);
    }
    return block;
}

}  // namespace

void AirPass::add_groups(const Tables::Pack& pack, std::span<const Vec3> colours, std::vector<Group>& groups) {
    const AirlightTables t = airlight_tables(pack, nodes_per_piece);
    const PackPhases phases(pack.optics);
    for (int first = 0; first < pack.optics.wavelength_count; first += gpu_wavelengths) {
        const std::array<Four, 6> block = colours_of(pack.optics, first, colours);
        groups.push_back({gpu::Buffer(airlight_block(t.air, first)), gpu::Buffer(std::as_bytes(std::span(block))),
                          gpu::Texture({t.air.density_axis.texels, 2}, gpu_densities(t)), texture_of(t.transmittance, false, first),
                          texture_of(t.source, true, first), texture_of(t.diffuse, false, first), texture_of(phases, first)});
    }
}

Result<AirPass> AirPass::create(const Tables& tables, std::span<const Vec3> colours) {
    assert(colours.size() == tables.wavelengths().size());
    Result<gpu::Program> made = program("fullscreen.vert", "air.frag");
    if (!made) return made.error();
    glUniformBlockBinding(made->name(), glGetUniformBlockIndex(made->name(), "AirlightBlock"), air_binding);
    std::vector<Group> groups;
    for (std::size_t p = 0; p < tables.packs().size(); ++p) {
        const Tables::Pack& pack = tables.packs()[p];
        const auto count = static_cast<std::size_t>(pack.optics.wavelength_count);
        add_groups(pack, colours.subspan(p * static_cast<std::size_t>(pack_size), count), groups);
    }
    return AirPass(std::move(*made), std::move(groups), tables.atmosphere().bottom_radius.in(m));
}

AirPass::AirPass(gpu::Program program, std::vector<Group> groups, double bottom_m)
    : program_(std::move(program)), groups_(std::move(groups)), bottom_m_(bottom_m), view_(2 * sizeof(Four)) {}

void AirPass::Group::bind() const {
    air.bind_uniform(air_binding);
    colours.bind_uniform(colours_binding);
    unsigned binding = 4;
    for (const gpu::Texture* texture : {&densities, &transmittance, &source, &diffuse, &phases}) texture->bind_sampler(binding++);
}

void AirPass::draw(const GeometryBuffer& surfaces, const Camera& camera, Vec3 towards_sun) const {
    const double radius_m = glm::length(camera.eye);
    const std::array<Four, 2> view = {four(camera.eye / radius_m, radius_m - bottom_m_), four(towards_sun, 0.0)};
    view_.write(std::as_bytes(std::span(view)));
    view_.bind_uniform(view_binding);
    unsigned binding = 0;
    for (const gpu::Texture* texture : {&surfaces.depth(), &surfaces.colour(), &surfaces.normal(), &surfaces.material()})
        texture->bind_sampler(binding++);
    program_.use();
    glDisable(GL_DEPTH_TEST);
    glBlendFunc(GL_ONE, GL_ONE);
    for (const Group& group : groups_) {
        group.bind();
        triangle_.draw_triangles(3);
        glEnable(GL_BLEND);  // the next adds to it
    }
    glDisable(GL_BLEND);
}

}  // namespace airlight::render
