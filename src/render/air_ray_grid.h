// The rays along which a method of air keeps the light of a frame: a column of texels for each azimuth from the sun and each row of view
// zenith angles, a layer for each place on the way (src/render/shaders/air_rays.glsl). How light is gathered along them is the method's;
// air_lookup.frag makes pictures of them. Uses sky (the rows of directions) and gpu.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "gpu/texture.h"
#include "physics/f32.h"
#include "render/air_method.h"
#include "render/shaders.h"
#include "sky/dome_rows.h"
#include "transport/air_optics.h"

namespace airlight::render {

// Light at the wavelengths of a pack for a texel of a table.
using PackLight = std::function<f32::IrradianceSpectrum(std::size_t pack, int column, int row)>;

class AirRayGrid {
public:
    // An atmosphere in packs of wavelengths, and the colours of radiance at all of them.
    struct Air {
        std::vector<AirOptics> packs;
        std::span<const Vec3> colours;
    };
    // The tables that know no eye: irradiance by the sun's disk, by altitude_coordinate and transmittance_cosine_coordinate, and that of
    // a level surface by the sky, by altitude_coordinate and sun_coordinate.
    static constexpr int sunlight_cosines = 256, sunlight_altitudes = 32, skylight_suns = 256, skylight_altitudes = 32;
    AirRayGrid(const Air& air, std::span<const double> jumps_m, const PackLight& sunlight, const PackLight& skylight);

    // What is left of the ground's skylight above it: as much as air there takes of the light that the whole air takes from above, as if
    // light were scattered once. Of transmittances straight up from there and from the ground.
    static f32::Spectrum skylight_left(const f32::Spectrum& from_there, const f32::Spectrum& from_ground);

    // Gathers the light of an eye by a program whose text is made of air_march.glsl: once for each group of four wavelengths, after
    // bind(group).
    void march(const AirEye& eye, const gpu::Program& program, const std::function<void(std::size_t)>& bind) const;

    // Keeps the sky that was gathered, by the program air_sky.comp.
    void keep_sky(const gpu::Program& program) const;

    // For air_lookup.frag.
    void bind() const;

private:
    struct Grid;
    static const Grid day_grid, shadow_grid, space_grid;
    const Grid& grid_of(Length altitude, double sun_zenith) const;
    int most_rows() const;
    void write_rays(const AirEye& eye, const DomeRows& rows, const Grid& grid) const;

    Shell shell_;
    std::vector<double> jumps_m_;  // of density
    gpu::Texture peak_, sunlight_, skylight_;
    gpu::Buffer rays_, ways_;
    std::vector<gpu::Buffer> shares_;  // of each group
    gpu::Texture gathered_, sky_;
};

// A method of air that gathers the light of such rays by its own program. `Group`: what the program reads for four wavelengths, which it
// binds by bind(). What is gathered stays as long as the settled eye does.
template <class Group>
class AirOfRays : public AirMethod {
public:
    static Result<std::unique_ptr<AirMethod>> create(gpu::Program march, std::vector<Group> groups, AirRayGrid grid) {
        Result<gpu::Program> sky = compute_program("air_sky.comp");
        if (!sky) return sky.error();
        return std::unique_ptr<AirMethod>(new AirOfRays(std::move(march), *std::move(sky), std::move(groups), std::move(grid)));
    }

    std::string shader() const override { return "air_lookup.frag"; }
    void prepare(const AirEye& eye, gpu::PassTimers& timers) override {
        const auto pass = timers.time("air rays");
        if (const AirEye at = settled(eye); gathered_ != at) {
            grid_.march(at, march_, [&](std::size_t group) { groups_[group].bind(); });
            grid_.keep_sky(sky_);
            gathered_ = at;
        }
    }
    int pictures() const override { return 1; }
    void bind(int) const override { grid_.bind(); }

private:
    AirOfRays(gpu::Program march, gpu::Program sky, std::vector<Group> groups, AirRayGrid grid)
        : march_(std::move(march)), sky_(std::move(sky)), groups_(std::move(groups)), grid_(std::move(grid)) {}

    gpu::Program march_, sky_;
    std::vector<Group> groups_;
    AirRayGrid grid_;
    std::optional<AirEye> gathered_;
};

}  // namespace airlight::render
