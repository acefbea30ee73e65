#include "render/bruneton2008_air.h"

#include <epoxy/gl.h>

#include <array>
#include <chrono>
#include <utility>

#include "models/airlight_block.h"

namespace airlight::render {

namespace {

constexpr unsigned colours_binding = 3, block_binding = 4;
// Of air_wavelengths.glsl, and the method's own.
constexpr unsigned densities_at = first_method_texture, transmittance_at = densities_at + 1, diffuse_at = densities_at + 3,
                   phases_at = densities_at + 4, scattering_at = densities_at + 5;

// How long slices are done for between two pictures, the last of them to its end.
constexpr std::chrono::milliseconds between_pictures{10};

// `uniform Bruneton2008Block`, after its axis of altitudes.
struct Block {
    int view, sun, nu;
    int scatterers, twilight, padding[3];
    int part_of[8];
};

gpu::Buffer block_of(const Bruneton2008Textures& textures) {
    Block block{.view = textures.texels.view,
                .sun = textures.texels.sun,
                .nu = textures.texels.nu,
                .scatterers = static_cast<int>(textures.parts.size()),
                .twilight = textures.texels.twilight,
                .padding = {},
                .part_of = {}};
    for (std::size_t i = 0; i < textures.parts.size(); ++i) block.part_of[i] = static_cast<int>(textures.parts[i]);
    std::vector<std::byte> bytes = airlight_axis_block(airlight_axis(textures.altitudes));
    const auto rest = std::as_bytes(std::span(&block, 1));
    bytes.insert(bytes.end(), rest.begin(), rest.end());
    return gpu::Buffer(bytes);
}

// `uniform AirColours`: of the four wavelengths from `first` on, black beyond the last.
gpu::Buffer colours_of(std::size_t first, const std::vector<Vec3>& colours) {
    std::array<Four, gpu_wavelengths> block{};
    for (std::size_t w = 0; w < block.size() && first + w < colours.size(); ++w) block[w] = four(colours[first + w], 0.0);
    return gpu::Buffer(std::as_bytes(std::span(block)));
}

}  // namespace

Bruneton2008Air::Bruneton2008Air(Bruneton2008Bake bake, std::span<const Vec3> colours)
    : colours_(colours.begin(), colours.end()), bake_(std::move(bake)) {}

bool Bruneton2008Air::begin(gpu::PassTimers& timers) {
    using Clock = std::chrono::steady_clock;
    for (const auto start = Clock::now(); bake_ && Clock::now() - start < between_pictures;) {
        advance(timers);
        glFinish();
    }
    return !bake_;
}

void Bruneton2008Air::prepare(const AirEye&, gpu::PassTimers& timers) {
    while (bake_) advance(timers);
}

// By a slice.
void Bruneton2008Air::advance(gpu::PassTimers& timers) {
    bake_->advance(timers);
    if (bake_->done() < bake_->slices()) return;
    Bruneton2008Textures textures = std::move(*bake_).take();
    bake_.reset();
    std::vector<gpu::Buffer> colours;
    for (std::size_t g = 0; g < textures.groups.size(); ++g) colours.push_back(colours_of(g * gpu_wavelengths, colours_));
    gpu::Buffer block = block_of(textures);
    tables_.emplace(Tables{std::move(textures), std::move(colours), std::move(block)});
}

int Bruneton2008Air::pictures() const { return static_cast<int>(tables_->textures.groups.size()); }

void Bruneton2008Air::bind(int picture) const {
    const auto g = static_cast<std::size_t>(picture);
    const Bruneton2008Group& group = tables_->textures.groups[g];
    group.air.bind_uniform(airlight_block_binding);
    tables_->colours[g].bind_uniform(colours_binding);
    tables_->block.bind_uniform(block_binding);
    tables_->textures.densities.bind_sampler(densities_at);
    group.transmittance.bind_sampler(transmittance_at);
    group.irradiance.bind_sampler(diffuse_at);
    group.phases.bind_sampler(phases_at);
    group.scattering.bind_sampler(scattering_at);
}

}  // namespace airlight::render
