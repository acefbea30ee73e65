#include "render/air_ray_grid.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "models/airlight_block.h"
#include "physics/models/f32.h"
#include "sky/gathered_dome.h"
#include "sky/pack_phases.h"

namespace airlight::render {

// Directions, as GatheredDome has them, and places on the way of each beyond the first, at the eye.
struct AirRayGrid::Grid {
    int sky_rows, ground_rows, azimuths, layers;
};
// By day; where the edge of the planet's shadow may be seen, which is sharp; and above the air, where it crosses what is seen of the planet.
constexpr AirRayGrid::Grid AirRayGrid::day_grid{.sky_rows = 32, .ground_rows = 20, .azimuths = 13, .layers = 14};
constexpr AirRayGrid::Grid AirRayGrid::shadow_grid{.sky_rows = 32, .ground_rows = 18, .azimuths = 15, .layers = 18};
constexpr AirRayGrid::Grid AirRayGrid::space_grid{.sky_rows = 48, .ground_rows = 32, .azimuths = 33, .layers = 8};

namespace {

constexpr std::size_t most_sky_segments = 9;
constexpr unsigned rays_binding = 4, ways_binding = 5, share_binding = 6, peak_in_march = first_method_texture + 5;
constexpr unsigned group_width = 8, group_height = 2, sky_group_width = 8, sky_group_height = 8;
constexpr int kept_sky_rows = 64, sky_parts = 2, ray_parts = 4;  // as air_rays.glsl has them

// std140: `uniform AirRays`.
struct RaysBlock {
    std::array<int, 4> counts{};
    Four eye{}, ground{};
    std::array<Four, most_sky_segments> sky_segments{};
};

// std140: `uniform AirShare`.
struct ShareBlock {
    std::array<int, 4> share{};
    std::array<float, f32::airlight_parts> peaked{};
};

float as_float(double x) { return static_cast<float>(x); }

bool has_peak(const AirOptics::Part& part) { return part.scatters && !part.phase.is_rayleigh(); }

// The mean phase function of all that has a peak, by its share of scattered sunlight: four floats a texel, even in the root of the sine of
// half the scattering angle.
std::vector<float> reference_phase(const std::vector<AirOptics>& packs) {
    constexpr int samples = 1024;
    std::vector<double> sum(samples, 0.0);
    double shares = 0.0;
    for (const AirOptics& optics : packs)
        for (const AirOptics::Part& part : optics.parts) {
            if (!has_peak(part)) continue;
            const double column = column_depth(part.profile, Length::of(optics.top_altitude.value)).value;
            std::array<double, pack_size> share{};
            for (int w = 0; w < optics.wavelength_count; ++w) {
                share[static_cast<std::size_t>(w)] = column * part.scattering[w].value * optics.solar_irradiance[w].value;
                shares += share[static_cast<std::size_t>(w)];
            }
            for (int k = 0; k < samples; ++k) {
                const double x = static_cast<double>(k) / (samples - 1);
                const f64::PhaseSpectrum phase = part.phase.at(1.0 - 2.0 * x * x * x * x);
                for (int w = 0; w < pack_size; ++w) sum[static_cast<std::size_t>(k)] += share[static_cast<std::size_t>(w)] * phase[w].value;
            }
        }
    std::vector<float> texels;
    for (const double x : sum) {
        const float phase = shares > 0.0 ? as_float(x / shares) : 1.0f;
        texels.insert(texels.end(), {phase, phase, phase, 1.0f});
    }
    return texels;
}

// Filtered places at the edge of what a grid fills have a share of 0 of what lies beyond, which must be a number.
gpu::Texture of_zeros(gpu::TextureSize size) {
    return gpu::Texture(size, std::vector<float>(static_cast<std::size_t>(4 * size.width * size.height * std::max(size.depth, 1)), 0.0f));
}

gpu::Texture texture_of_row(const std::vector<float>& texels) { return gpu::Texture({static_cast<int>(texels.size()) / 4, 1}, texels); }

// A table of the logarithms of colours.
gpu::Texture colour_table(const AirRayGrid::Air& air, int width, int height, const PackLight& light) {
    std::vector<float> texels(static_cast<std::size_t>(4 * width * height), 0.0f);
    for (std::size_t p = 0; p < air.packs.size(); ++p)
        for (int j = 0; j < height; ++j)
            for (int i = 0; i < width; ++i) {
                const f32::IrradianceSpectrum spectrum = light(p, i, j);
                Vec3 sum(0.0);
                for (int w = 0; w < air.packs[p].wavelength_count; ++w)
                    sum += air.colours[p * static_cast<std::size_t>(pack_size) + static_cast<std::size_t>(w)] *
                           static_cast<double>(spectrum.v[w]);
                for (int c = 0; c < 3; ++c) texels[static_cast<std::size_t>(4 * (j * width + i) + c)] += as_float(sum[c]);
            }
    for (float& x : texels) x = std::log(std::max(x, 1e-12f));  // a colour beyond the primaries has none of one of them
    return gpu::Texture({width, height}, texels);
}

std::vector<gpu::Buffer> shares_of(const std::vector<AirOptics>& packs) {
    int groups = 0;
    for (const AirOptics& optics : packs) groups += (optics.wavelength_count + gpu_wavelengths - 1) / gpu_wavelengths;
    ShareBlock block;
    for (std::size_t p = 0; p < std::min(packs[0].parts.size(), block.peaked.size()); ++p) block.peaked[p] = has_peak(packs[0].parts[p]);
    std::vector<gpu::Buffer> shares;
    for (int g = 0; g < groups; ++g) {
        block.share = {g == 0, g + 1 == groups, 0, 0};
        shares.emplace_back(std::as_bytes(std::span(&block, 1)));
    }
    return shares;
}

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

unsigned groups_of(int texels, unsigned size) { return (static_cast<unsigned>(texels) + size - 1) / size; }

}  // namespace

AirRayGrid::AirRayGrid(const Air& air, std::span<const double> jumps_m, const PackLight& sunlight, const PackLight& skylight)
    : shell_{air.packs[0].bottom_radius.value, air.packs[0].top_altitude.value},
      jumps_m_(jumps_m.begin(), jumps_m.begin() + static_cast<std::ptrdiff_t>(std::min(jumps_m.size(), most_sky_segments - 1))),
      peak_(texture_of_row(reference_phase(air.packs))),
      sunlight_(colour_table(air, sunlight_cosines, sunlight_altitudes, sunlight)),
      skylight_(colour_table(air, skylight_suns, skylight_altitudes, skylight)),
      rays_(sizeof(RaysBlock)),
      ways_(sizeof(Four) * static_cast<std::size_t>(most_rows())),
      shares_(shares_of(air.packs)),
      gathered_(of_zeros({ray_parts * space_grid.azimuths, most_rows(), shadow_grid.layers + 1})),
      sky_(of_zeros({sky_parts * space_grid.azimuths, kept_sky_rows})) {}

f32::Spectrum AirRayGrid::skylight_left(const f32::Spectrum& from_there, const f32::Spectrum& from_ground) {
    const f32::Spectrum all(f32::Number(1.0f));
    return (all - from_there) / max(all - from_ground, f32::Spectrum(f32::Number(1e-9f)));
}

const AirRayGrid::Grid& AirRayGrid::grid_of(Length altitude, double sun_zenith) const {
    if (altitude.value > shell_.top_m) return space_grid;
    return DomeEye{shell_, jumps_m_, altitude, sun_zenith}.sees_shadow() ? shadow_grid : day_grid;
}

int AirRayGrid::most_rows() const {
    int most = 0;
    for (const Grid& grid : {day_grid, shadow_grid, space_grid})
        most = std::max(most, grid.sky_rows + static_cast<int>(jumps_m_.size()) * std::max(4, grid.sky_rows / 3) + grid.ground_rows);
    return most;
}

void AirRayGrid::write_rays(const AirEye& eye, const DomeRows& rows, const Grid& grid) const {
    RaysBlock block;
    const double h = std::max(eye.altitude_m, DomeRows::lowest_eye_m);
    const double horizon_m = std::sqrt(h * (2.0 * shell_.bottom_m + h));
    const DomeRows::Segment& ground = rows.segments().back();
    block.counts = {ground.first, grid.azimuths, rows.size(), grid.layers};
    block.eye = {as_float(h), as_float(std::min(h / shell_.top_m, 1.0)), as_float(eye.mu_s), 0.0f};
    block.ground = {as_float(std::log(horizon_m)), as_float(0.5 / std::log(horizon_m / h)), as_float(ground.from),
                    as_float(0.5 / (ground.to - ground.from))};
    block.sky_segments.fill({4.0f, 5.0f, 0.0f, 0.0f});
    for (std::size_t s = 0; s + 1 < rows.segments().size(); ++s) {
        const DomeRows::Segment& segment = rows.segments()[s];
        block.sky_segments[s] = {as_float(segment.from), as_float(segment.to), as_float(segment.first), as_float(segment.count)};
    }
    std::vector<Four> ways;
    for (int row = 0; row < rows.size(); ++row) ways.push_back(way_of(shell_, h, rows.zenith(row), row >= ground.first));
    rays_.write(std::as_bytes(std::span(&block, 1)));
    ways_.write(std::as_bytes(std::span(ways)));
}

void AirRayGrid::march(const AirEye& eye, const gpu::Program& program, const std::function<void(std::size_t)>& bind) const {
    const Length altitude = Length::of(std::max(eye.altitude_m, 0.0));
    const Grid& grid = grid_of(altitude, std::acos(std::clamp(eye.mu_s, -1.0, 1.0)));
    const DomeRows rows(shell_, altitude, jumps_m_, grid.sky_rows, grid.ground_rows);
    write_rays(eye, rows, grid);
    rays_.bind_uniform(rays_binding);
    ways_.bind_storage(ways_binding);
    peak_.bind_sampler(peak_in_march);
    gathered_.bind_image(0);
    program.use();
    for (std::size_t g = 0; g < shares_.size(); ++g) {
        bind(g);
        shares_[g].bind_uniform(share_binding);
        program.dispatch(groups_of(grid.azimuths, group_width), groups_of(rows.size(), group_height));
    }
}

void AirRayGrid::keep_sky(const gpu::Program& program) const {
    bind();
    sky_.bind_image(0);
    program.use();
    program.dispatch(groups_of(space_grid.azimuths, sky_group_width), groups_of(kept_sky_rows, sky_group_height));
}

void AirRayGrid::bind() const {
    rays_.bind_uniform(rays_binding);
    unsigned binding = first_method_texture;
    for (const gpu::Texture* texture : {&gathered_, &peak_, &sunlight_, &skylight_, &sky_}) texture->bind_sampler(binding++);
}

}  // namespace airlight::render
