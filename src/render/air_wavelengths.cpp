#include "render/air_wavelengths.h"

#include <array>
#include <cassert>

#include "models/airlight_block.h"
#include "render/air_method.h"

namespace airlight::render {

namespace {

constexpr unsigned colours_binding = 3;

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
    for (std::size_t w = 0; w < 4; ++w) {
        const std::size_t at = static_cast<std::size_t>(first) + w;
        if (at < colours.size()) block[w] = four(colours[at], 0.0);
        block[4][w] = static_cast<float>(optics.sun.limb_darkening_1.at(optics.wavelengths[at]).value);
        block[5][w] = static_cast<float>(optics.sun.limb_darkening_2.at(optics.wavelengths[at]).value);
    }
    return block;
}

// Of a pack, whose `colours` are those of its wavelengths.
void add_groups(const Tables::Pack& pack, std::span<const Vec3> colours, int nodes, std::vector<AirWavelengths>& groups) {
    const AirlightTables t = airlight_tables(pack, nodes);
    const PackPhases phases(pack.optics);
    for (int first = 0; first < pack.optics.wavelength_count; first += gpu_wavelengths) {
        const std::array<Four, 6> block = colours_of(pack.optics, first, colours);
        groups.push_back({gpu::Buffer(airlight_block(t.air, first)), gpu::Buffer(std::as_bytes(std::span(block))),
                          gpu::Texture({t.air.density_axis.texels, 2}, gpu_densities(t)), texture_of(t.transmittance, false, first),
                          texture_of(t.source, true, first), texture_of(t.diffuse, false, first), texture_of(phases, first)});
    }
}

}  // namespace

void AirWavelengths::bind() const {
    air.bind_uniform(airlight_block_binding);
    colours.bind_uniform(colours_binding);
    unsigned binding = first_method_texture;
    for (const gpu::Texture* texture : {&densities, &transmittance, &source, &diffuse, &phases}) texture->bind_sampler(binding++);
}

std::vector<AirWavelengths> air_wavelengths(const Tables& tables, std::span<const Vec3> colours, int nodes) {
    assert(colours.size() == tables.wavelengths().size());
    std::vector<AirWavelengths> groups;
    for (std::size_t p = 0; p < tables.packs().size(); ++p) {
        const Tables::Pack& pack = tables.packs()[p];
        const auto count = static_cast<std::size_t>(pack.optics.wavelength_count);
        add_groups(pack, colours.subspan(p * static_cast<std::size_t>(pack_size), count), nodes, groups);
    }
    return groups;
}

}  // namespace airlight::render
