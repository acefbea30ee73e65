#include "render/air_exact.h"

#include <array>
#include <cassert>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/texture.h"
#include "models/airlight_block.h"

namespace airlight::render {

namespace {

using Four = std::array<float, 4>;

// On a piece of a ray. tests/parity/air_pass_test.cpp: within 1.1 % of twelve from space at sunset, 0.4 % elsewhere.
constexpr int nodes_per_piece = 8;

constexpr unsigned air_binding = 1, colours_binding = 3, first_texture = 8;

gpu::Texture texture_of(const PackedTexels& table, bool deep, int first) {
    return gpu::Texture({table.size[0], table.size[1], deep ? table.size[2] : 0}, gpu_texels(table, first));
}

gpu::Texture texture_of(const PackPhases& phases, int first) {
    const std::vector<float> texels = gpu_phases(phases, first);
    const int row = 4 * f32::airlight_parts;
    return gpu::Texture({static_cast<int>(texels.size()) / row, f32::airlight_parts}, texels);
}

// `uniform AirColours`.
std::array<Four, 4> colours_of(int first, std::span<const Vec3> colours) {
    std::array<Four, 4> block{};
    for (std::size_t w = 0; w < block.size(); ++w) {
        const std::size_t at = static_cast<std::size_t>(first) + w;
        if (at >= colours.size()) continue;
        for (int c = 0; c < 3; ++c) block[w][static_cast<std::size_t>(c)] = static_cast<float>(colours[at][c]);
    }
    return block;
}

// Four wavelengths.
struct Group {
    gpu::Buffer air, colours;
    gpu::Texture densities, transmittance, source, diffuse, phases;
};

// Of a pack, whose `colours` are those of its wavelengths.
void add_groups(const Tables::Pack& pack, std::span<const Vec3> colours, std::vector<Group>& groups) {
    const AirlightTables t = airlight_tables(pack, nodes_per_piece);
    const PackPhases phases(pack.optics);
    for (int first = 0; first < pack.optics.wavelength_count; first += gpu_wavelengths) {
        const std::array<Four, 4> block = colours_of(first, colours);
        groups.push_back({gpu::Buffer(airlight_block(t.air, first)), gpu::Buffer(std::as_bytes(std::span(block))),
                          gpu::Texture({t.air.density_axis.texels, 2}, gpu_densities(t)), texture_of(t.transmittance, false, first),
                          texture_of(t.source, true, first), texture_of(t.diffuse, false, first), texture_of(phases, first)});
    }
}

class ExactAir : public AirMethod {
public:
    ExactAir(const Tables& tables, std::span<const Vec3> colours) {
        for (std::size_t p = 0; p < tables.packs().size(); ++p) {
            const Tables::Pack& pack = tables.packs()[p];
            const auto count = static_cast<std::size_t>(pack.optics.wavelength_count);
            add_groups(pack, colours.subspan(p * static_cast<std::size_t>(pack_size), count), groups_);
        }
    }

    std::string shader() const override { return "air_exact.frag"; }
    void prepare(const Camera&, Vec3, gpu::PassTimers&) override {}
    int pictures() const override { return static_cast<int>(groups_.size()); }
    void bind(int picture) const override {
        const Group& group = groups_[static_cast<std::size_t>(picture)];
        group.air.bind_uniform(air_binding);
        group.colours.bind_uniform(colours_binding);
        unsigned binding = first_texture;
        for (const gpu::Texture* texture : {&group.densities, &group.transmittance, &group.source, &group.diffuse, &group.phases})
            texture->bind_sampler(binding++);
    }

private:
    std::vector<Group> groups_;
};

}  // namespace

std::unique_ptr<AirMethod> exact_air(const Tables& tables, std::span<const Vec3> colours) {
    assert(colours.size() == tables.wavelengths().size());
    return std::make_unique<ExactAir>(tables, colours);
}

}  // namespace airlight::render
