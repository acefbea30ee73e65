#include "render/air_hillaire2020.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "core/parallel.h"
#include "core/quadrature.h"
#include "models/airlight_block.h"
#include "models/hillaire2020_tables.h"
#include "models/optical_depths.h"
#include "render/air_ray_grid.h"
#include "render/shaders.h"
#include "transport/pack_tables.h"

namespace airlight::render {

namespace {

constexpr unsigned block_binding = 1;
constexpr int phase_samples = 1024;

// std140: `uniform HillaireBlock`.
struct Block {
    float bottom, top, unused[2];
    Four albedo;
    int medium_size, transmittance_across, transmittance_down, multiple_size;
    Four solar_irradiance;
    std::array<Four, 4> colour_of_wavelength;
};
static_assert(sizeof(Block) == 128);

// Four wavelengths of a pack, from the first.
template <class S>
Four four_of(const S& spectrum, int first) {
    Four values{};
    for (std::size_t w = 0; w < values.size(); ++w) values[w] = static_cast<float>(spectrum.v[first + static_cast<int>(w)]);
    return values;
}

template <class S>
gpu::Texture texture_of(std::span<const S> texels, int width, int first) {
    std::vector<float> values;
    for (const S& texel : texels) {
        const Four four = four_of(texel, first);
        values.insert(values.end(), four.begin(), four.end());
    }
    return gpu::Texture({width, static_cast<int>(texels.size()) / width}, values);
}

gpu::Texture phases_of(const Hillaire2020Tables& tables, int first) {
    std::vector<f32::PhaseSpectrum> rows;
    for (const bool air : {true, false})
        for (int k = 0; k < phase_samples; ++k) {
            const double x = static_cast<double>(k) / (phase_samples - 1), nu = std::cos(pi * x * x);
            rows.push_back(air ? tables.air_phase(nu) : tables.aerosol_phase(nu));
        }
    return texture_of(std::span<const f32::PhaseSpectrum>(rows), phase_samples, first);
}

// Four wavelengths.
struct Group {
    gpu::Buffer block;
    gpu::Texture medium, transmittance, multiple, phases;
    void bind() const {
        block.bind_uniform(block_binding);
        unsigned binding = first_method_texture;
        for (const gpu::Texture* texture : {&medium, &transmittance, &multiple, &phases}) texture->bind_sampler(binding++);
    }
};

// `colours`: of the pack's wavelengths.
Group group_of(const Hillaire2020Tables& tables, std::span<const Vec3> colours, int first) {
    const f32::Hillaire2020& sky = tables.sky();
    Block block{.bottom = sky.bottom.value,
                .top = sky.top.value,
                .unused = {},
                .albedo = four_of(sky.albedo, first),
                .medium_size = sky.medium_size,
                .transmittance_across = sky.transmittance_across,
                .transmittance_down = sky.transmittance_down,
                .multiple_size = sky.multiple_size,
                .solar_irradiance = four_of(tables.sun(), first),
                .colour_of_wavelength = {}};
    for (std::size_t w = 0; w < block.colour_of_wavelength.size(); ++w)
        if (static_cast<std::size_t>(first) + w < colours.size())
            block.colour_of_wavelength[w] = four(colours[static_cast<std::size_t>(first) + w], 0.0);
    return {gpu::Buffer(std::as_bytes(std::span(&block, 1))), texture_of(tables.medium_texels(), sky.medium_size, first),
            texture_of(tables.transmittance_texels(), sky.transmittance_across, first),
            texture_of(tables.multiple_texels(), sky.multiple_size, first), phases_of(tables, first)};
}

using Packs = std::vector<Hillaire2020Tables>;

std::vector<Group> groups_of(const Packs& packs, std::span<const Vec3> colours) {
    std::vector<Group> groups;
    for (std::size_t p = 0; p < packs.size(); ++p)
        for (int first = 0; first < packs[p].count(); first += gpu_wavelengths)
            groups.push_back(group_of(
                packs[p], colours.subspan(p * static_cast<std::size_t>(pack_size), static_cast<std::size_t>(packs[p].count())), first));
    return groups;
}

// Irradiance of level ground by his sky: over the zenith angle by Gauss's rule in the square of its sine, over azimuth at even steps.
f32::IrradianceSpectrum sky_on_ground(const Hillaire2020Tables& tables, double mu_s) {
    constexpr int azimuths = 12;
    const GaussRule rule = gauss_rule(8, 0.0, 1.0);
    f32::IrradianceSpectrum sum(f32::IrradianceSpectrum::Scalar::of(0.0f));
    for (std::size_t i = 0; i < rule.nodes.size(); ++i)
        for (int j = 0; j < azimuths; ++j) {
            const double mu = std::sqrt(1.0 - rule.nodes[i]);
            const double nu = mu * mu_s + std::sqrt((1.0 - mu * mu) * (1.0 - mu_s * mu_s)) * std::cos(pi * (j + 0.5) / azimuths);
            const f32::RadianceSpectrum seen = tables.light({0.0, mu, mu_s, std::clamp(nu, -1.0, 1.0)}).inscattered;
            for (int w = 0; w < pack_size; ++w) sum.v[w] += seen.v[w] * static_cast<float>(pi * rule.weights[i] / azimuths);
        }
    return sum;
}

AirRayGrid grid_of(const Packs& packs, const ColouredAir& air) {
    AirRayGrid::Air optics{{}, air.colours};
    for (const std::vector<Wavelength>& pack : airlight::packs(air.wavelengths)) optics.packs.push_back(air_optics(air.atmosphere, pack));
    const auto part = [](int i, int count) { return f32::Number(static_cast<double>(i) / (count - 1)); };
    const PackLight sunlight = [&](std::size_t p, int i, int j) {
        const f32::Hillaire2020& sky = packs[p].sky();
        const f32::Length h = f32::altitude_of_coordinate(part(j, AirRayGrid::sunlight_altitudes), sky.top);
        const f32::Number mu = f32::transmittance_cosine_of_coordinate(h, part(i, AirRayGrid::sunlight_cosines), sky.bottom, sky.top);
        // A hair above the horizon, at which the text has no light.
        return f32::hillaire2020_sunlight(packs[p].transmittance(), sky, h, mu + f32::Number(1e-6)) * packs[p].sun();
    };
    std::vector<std::vector<f32::IrradianceSpectrum>> ground(packs.size());
    for (std::size_t p = 0; p < packs.size(); ++p) {
        ground[p].resize(AirRayGrid::skylight_suns);
        parallel_for(ground[p].size(), [&](std::size_t i) {
            const f32::Number mu_s = f32::sun_of_coordinate(part(static_cast<int>(i), AirRayGrid::skylight_suns));
            ground[p][i] = sky_on_ground(packs[p], static_cast<double>(mu_s.value));
        });
    }
    const PackLight skylight = [&](std::size_t p, int i, int j) {
        const f32::Hillaire2020& sky = packs[p].sky();
        const auto upward = [&](f32::Length h) { return f32::hillaire2020_sunlight(packs[p].transmittance(), sky, h, f32::Number(1.0f)); };
        const f32::Length h = f32::altitude_of_coordinate(part(j, AirRayGrid::skylight_altitudes), sky.top);
        return ground[p][static_cast<std::size_t>(i)] * AirRayGrid::skylight_left(upward(h), upward(0.0f * f32::m));
    };
    const PackAir densities = pack_air(optics.packs[0], {});
    return AirRayGrid(optics, densities.densities.jumps_m(), sunlight, skylight);
}

Packs packs_of(const ColouredAir& air) {
    Packs packs;
    for (const std::vector<Wavelength>& pack : airlight::packs(air.wavelengths)) packs.emplace_back(air_optics(air.atmosphere, pack));
    return packs;
}

}  // namespace

Result<std::unique_ptr<AirMethod>> hillaire2020_air(const ColouredAir& air) {
    Result<gpu::Program> march = compute_program("air_hillaire2020.comp");
    if (!march) return march.error();
    const Packs packs = packs_of(air);
    return AirOfRays<Group>::create(*std::move(march), groups_of(packs, air.colours), grid_of(packs, air));
}

}  // namespace airlight::render
