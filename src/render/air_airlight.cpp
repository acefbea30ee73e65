#include "render/air_airlight.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "models/airlight_tables.h"
#include "render/air_wavelengths.h"
#include "render/shaders.h"
#include "sky/gathered_dome.h"
#include "sky/pack_phases.h"

namespace airlight::render {

namespace {

// Of a piece of a ray between two layers.
constexpr int nodes_per_piece = 2;

// Directions, as GatheredDome has them, and places on the way of each beyond the first, at the eye.
struct Grid {
    int sky_rows, ground_rows, azimuths, layers;
};
// By day; where the edge of the planet's shadow may be seen, which is sharp; and above the air, where it crosses what is seen of the planet.
constexpr Grid day_grid{.sky_rows = 24, .ground_rows = 12, .azimuths = 13, .layers = 10},
    shadow_grid{.sky_rows = 24, .ground_rows = 18, .azimuths = 15, .layers = 18},
    space_grid{.sky_rows = 28, .ground_rows = 24, .azimuths = 25, .layers = 12};
const Grid& grid_of(const DomeEye& eye) {
    if (eye.altitude.value > eye.shell.top_m) return space_grid;
    return eye.sees_shadow() ? shadow_grid : day_grid;
}
constexpr std::size_t most_segments = 10;

constexpr unsigned rays_binding = 4, ways_binding = 5, share_binding = 6;
constexpr unsigned group_width = 8, group_height = 2;

// Of the tables that know no eye.
constexpr int sunlight_cosines = 256, sunlight_altitudes = 32, skylight_suns = 256;

// std140: `uniform AirRays`.
struct RaysBlock {
    std::array<int, 4> counts{};
    Four eye{};
    std::array<Four, most_segments> segments{};
};

// std140: `uniform AirShare`.
struct ShareBlock {
    std::array<int, 4> share{};
    std::array<float, f32::airlight_parts> peaked{};
};

float as_float(double x) { return static_cast<float>(x); }

double column_scattering(const AirOptics& optics, std::size_t part, int wavelength) {
    const AirOptics::Part& p = optics.parts[part];
    return p.scattering[wavelength].value * column_depth(p.profile, Length::of(optics.top_altitude.value)).value;
}

// The mean phase function of all that has a peak, by its share of scattered sunlight: four floats a texel.
std::vector<float> reference_phase(const Tables& tables) {
    const std::size_t samples = PackPhases(tables.packs()[0].optics).samples().size() /
                                std::max<std::size_t>(PackPhases(tables.packs()[0].optics).parts().size(), 1);
    std::vector<double> sum(std::max<std::size_t>(samples, 2), 0.0);
    double shares = 0.0;
    for (const Tables::Pack& pack : tables.packs()) {
        const PackPhases phases(pack.optics);
        const std::size_t parts = phases.parts().size();
        for (std::size_t i = 0; i < parts; ++i) {
            const std::size_t part = phases.parts()[i];
            if (pack.optics.parts[part].phase.is_rayleigh()) continue;
            for (int w = 0; w < pack.optics.wavelength_count; ++w) {
                const double share = column_scattering(pack.optics, part, w) * pack.optics.solar_irradiance[w].value;
                shares += share;
                for (std::size_t k = 0; k < samples; ++k) sum[k] += share * static_cast<double>(phases.samples()[k * parts + i].v[w]);
            }
        }
    }
    std::vector<float> texels;
    for (const double x : sum) {
        const float phase = shares > 0.0 ? as_float(x / shares) : 1.0f;
        texels.insert(texels.end(), {phase, phase, phase, 1.0f});
    }
    return texels;
}

// A table of the logarithms of colours: `light` gives the light at the wavelengths of a pack for a texel.
template <class Light>
gpu::Texture colour_table(const Tables& tables, std::span<const Vec3> colours, int width, int height, Light light) {
    std::vector<float> texels(static_cast<std::size_t>(4 * width * height), 0.0f);
    for (std::size_t p = 0; p < tables.packs().size(); ++p) {
        const AirlightTables t = airlight_tables(tables.packs()[p], nodes_per_piece);
        for (int j = 0; j < height; ++j)
            for (int i = 0; i < width; ++i) {
                const f32::IrradianceSpectrum spectrum = light(t, i, j);
                Vec3 sum(0.0);
                for (int w = 0; w < tables.packs()[p].optics.wavelength_count; ++w)
                    sum +=
                        colours[p * static_cast<std::size_t>(pack_size) + static_cast<std::size_t>(w)] * static_cast<double>(spectrum.v[w]);
                for (int c = 0; c < 3; ++c) texels[static_cast<std::size_t>(4 * (j * width + i) + c)] += as_float(sum[c]);
            }
    }
    for (float& x : texels) x = std::log(std::max(x, 1e-12f));  // a colour beyond the primaries has none of one of them
    return gpu::Texture({width, height}, texels);
}

f32::Number part_of(int i, int count) { return f32::Number(static_cast<double>(i) / (count - 1)); }

gpu::Texture sunlight_table(const Tables& tables, std::span<const Vec3> colours) {
    return colour_table(tables, colours, sunlight_cosines, sunlight_altitudes, [](const AirlightTables& t, int i, int j) {
        const f32::Length h = f32::altitude_of_coordinate(part_of(j, sunlight_altitudes), t.air.top);
        const f32::Number mu = f32::transmittance_cosine_of_coordinate(h, part_of(i, sunlight_cosines), t.air.bottom, t.air.top);
        return f32::airlight_upward(t.air, t.transmittance_table(), h, mu) * t.air.solar_irradiance;
    });
}

gpu::Texture skylight_table(const Tables& tables, std::span<const Vec3> colours) {
    return colour_table(tables, colours, skylight_suns, 1, [](const AirlightTables& t, int i, int) {
        return f32::airlight_diffuse(t.air, t.diffuse_table(), f32::sun_of_coordinate(part_of(i, skylight_suns))) * t.air.solar_irradiance;
    });
}

std::array<float, f32::airlight_parts> peaked_parts(const AirOptics& optics) {
    std::array<float, f32::airlight_parts> peaked{};
    for (std::size_t p = 0; p < optics.parts.size(); ++p)
        peaked[p] = optics.parts[p].scatters && !optics.parts[p].phase.is_rayleigh() ? 1.0f : 0.0f;
    return peaked;
}

int most_rows(const Grid& grid, std::size_t jumps) {
    return grid.sky_rows + static_cast<int>(jumps) * std::max(4, grid.sky_rows / 3) + grid.ground_rows;
}

class AirlightAir : public AirMethod {
public:
    AirlightAir(const Tables& tables, std::span<const Vec3> colours, gpu::Program march)
        : shell_(tables.packs()[0].air.shell),
          jumps_m_(jumps_of(tables)),
          march_(std::move(march)),
          groups_(air_wavelengths(tables, colours, nodes_per_piece)),
          peak_({static_cast<int>(reference_phase(tables).size()) / 4, 1}, reference_phase(tables)),
          sunlight_(sunlight_table(tables, colours)),
          skylight_(skylight_table(tables, colours)),
          rays_block_(sizeof(RaysBlock)),
          ways_(sizeof(Four) * static_cast<std::size_t>(most_rows(space_grid, jumps_m_.size()))) {
        for (std::size_t g = 0; g < groups_.size(); ++g) {
            const ShareBlock share{{g == 0, g + 1 == groups_.size(), 0, 0}, peaked_parts(tables.packs()[0].optics)};
            shares_.emplace_back(std::as_bytes(std::span(&share, 1)));
        }
    }

    std::string shader() const override { return "air_airlight.frag"; }
    int pictures() const override { return 1; }

    void prepare(const AirEye& eye, gpu::PassTimers& timers) override {
        const auto pass = timers.time("air rays");
        const DomeEye dome{shell_, jumps_m_, Length::of(std::max(eye.altitude_m, 0.0)), std::acos(std::clamp(eye.mu_s, -1.0, 1.0))};
        const Grid& grid = grid_of(dome);
        const DomeRows rows(shell_, dome.altitude, jumps_m_, grid.sky_rows, grid.ground_rows);
        write_rays(dome.altitude.value, rows, grid);
        rays_block_.bind_uniform(rays_binding);
        ways_.bind_storage(ways_binding);
        peak_.bind_sampler(first_method_texture + 5);
        unsigned image = 0;
        for (const gpu::Texture* texture : {&smooth_, &peaked_, &extinction_, &once_}) texture->bind_image(image++);
        march_.use();
        for (std::size_t g = 0; g < groups_.size(); ++g) {
            groups_[g].bind();
            shares_[g].bind_uniform(share_binding);
            march_.dispatch((static_cast<unsigned>(grid.azimuths) + group_width - 1) / group_width,
                            (static_cast<unsigned>(rows.size()) + group_height - 1) / group_height);
        }
    }

    void bind(int) const override {
        rays_block_.bind_uniform(rays_binding);
        unsigned binding = first_method_texture;
        for (const gpu::Texture* texture : {&smooth_, &peaked_, &extinction_, &peak_, &sunlight_, &skylight_, &once_})
            texture->bind_sampler(binding++);
    }

private:
    static std::vector<double> jumps_of(const Tables& tables) {
        const auto jumps = tables.packs()[0].air.densities.jumps_m();
        const auto kept = jumps.first(std::min(jumps.size(), most_segments - 2));
        return {kept.begin(), kept.end()};
    }

    void write_rays(double altitude_m, const DomeRows& rows, const Grid& grid) const;

    Shell shell_;
    std::vector<double> jumps_m_;  // of density
    gpu::Program march_;
    std::vector<AirWavelengths> groups_;
    std::vector<gpu::Buffer> shares_;
    gpu::Texture peak_, sunlight_, skylight_;
    gpu::Buffer rays_block_, ways_;
    gpu::TextureSize size_{space_grid.azimuths, most_rows(space_grid, jumps_m_.size()), shadow_grid.layers + 1};
    gpu::Texture smooth_{size_}, peaked_{size_}, extinction_{size_}, once_{size_};
};

// The way in the air of a view: zenith cosine at the eye and where the air begins; empty way before; length, negative to the ground.
Four way_of(const Shell& shell, double altitude_m, double zenith, bool grounded) {
    const double mu = std::cos(zenith), r = shell.bottom_m + altitude_m, along = r * mu, beside = r * std::sin(zenith);
    const auto half_chord = [&](double radius) { return std::sqrt(std::max((radius - beside) * (radius + beside), 0.0)); };
    const double top = half_chord(shell.bottom_m + shell.top_m);
    const double empty = altitude_m > shell.top_m ? -along - top : 0.0;
    const double entered = std::min(r, shell.bottom_m + shell.top_m);
    const double end = grounded ? -along - half_chord(shell.bottom_m) : top - along;
    const double length = std::max(end - empty, 1e-3);
    return {as_float(mu), as_float((along + empty) / entered), as_float(empty), as_float(grounded ? -length : length)};
}

void AirlightAir::write_rays(double altitude_m, const DomeRows& rows, const Grid& grid) const {
    RaysBlock block;
    const double h = std::max(altitude_m, DomeRows::lowest_eye_m);
    block.counts = {static_cast<int>(rows.segments().size()), grid.azimuths, rows.size(), grid.layers};
    block.eye = {as_float(h), as_float(std::sqrt(h * (2.0 * shell_.bottom_m + h))), as_float(std::min(altitude_m / shell_.top_m, 1.0)),
                 0.0f};
    std::vector<Four> ways;
    for (std::size_t s = 0; s < rows.segments().size(); ++s) {
        const DomeRows::Segment& segment = rows.segments()[s];
        block.segments[s] = {as_float(segment.from), as_float(segment.to), as_float(segment.first), as_float(segment.count)};
        for (int i = 0; i < segment.count; ++i)
            ways.push_back(way_of(shell_, h, rows.zenith(segment.first + i), s + 1 == rows.segments().size()));
    }
    rays_block_.write(std::as_bytes(std::span(&block, 1)));
    ways_.write(std::as_bytes(std::span(ways)));
}

}  // namespace

Result<std::unique_ptr<AirMethod>> airlight_air(const Tables& tables, std::span<const Vec3> colours) {
    assert(colours.size() == tables.wavelengths().size());
    Result<gpu::Program> march = compute_program("air_march.comp");
    if (!march) return march.error();
    march->bind_block("AirlightBlock", airlight_block_binding);
    return std::unique_ptr<AirMethod>(std::make_unique<AirlightAir>(tables, colours, *std::move(march)));
}

}  // namespace airlight::render
