// The tables of bruneton2008 filled on the GPU: all passes of [Sperlhofer2011, fig. 4-26; BrunetonNeyret2008, alg. 4.1], four wavelengths
// at a time, in slices small enough to go between the frames of a viewer. What the tables mean: src/models/bruneton2008.cpp; the text
// of their maps and look-ups: physics/models/bruneton2008.glsl. Uses gpu, and of models the medium of `airlight`.
//
// The passes, with the names of the paper:
//   transmittance   optical depth to the top of the air
//   ways            what does not depend on the sun along each direction of an altitude: nodes by the text of `airlight`
//   radiance        light of one order around points (delta S), single scattering with its phase functions; light from the ground
//   turns, moments  the same in spherical harmonics, scattered
//   irradiance      of level surfaces (delta E and E)
//   density         what is scattered once more (delta J), and its sum over the orders
//   single, multiple  the scattering tables (S): integrals of sunlight and of that sum
// Light is linear in its source, so that the sum is integrated once, where the paper integrates each order and adds up.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "atmosphere/atmosphere.h"
#include "core/result.h"
#include "gpu/buffer.h"
#include "gpu/pass_timers.h"
#include "gpu/program.h"
#include "gpu/texture.h"
#include "models/bruneton2008.h"
#include "transport/altitude_axis.h"
#include "transport/bake_settings.h"

namespace airlight::render {

// The tables of four wavelengths: of group g, from the one numbered 4 g on; a last group that is not full repeats its last wavelength.
struct Bruneton2008Group {
    gpu::Buffer air;             // `uniform AirlightBlock`
    gpu::Texture transmittance;  // optical depth, as airlight_sunlight() reads it
    gpu::Texture irradiance;     // of level surfaces by the sky over the sun's: logarithms, [altitude][sun]
    gpu::Texture scattering;     // [table and altitude][view][nu and sun]: of all higher orders, then of single scattering in each part;
                                 // the root of the light, of ways to the ground over bruneton2008_gain()
    gpu::Texture phases;         // [constituent][sample], as gpu_phases()
};

struct Bruneton2008Textures {
    Bruneton2008Settings texels;
    AltitudeAxis altitudes;          // of the scattering tables: not the paper's, but with texels on both sides of jumps of density
    std::vector<std::size_t> parts;  // the constituents that scatter, in the order of the tables
    gpu::Texture densities;          // as airlight_densities() reads them
    std::vector<Bruneton2008Group> groups;
};

// Sizes of the transmittance and of the density that serve the Earth's air.
inline constexpr TableSizes sizes_around_points = {
    .transmittance_mu = 256, .transmittance_altitude = 64, .sun = 40, .azimuth = 8, .view = 16, .altitude = 20};

// Of the scattering tables: 48 MiB for each constituent that scatters, and for the higher orders, of four wavelengths.
inline constexpr Bruneton2008Settings fine_texels = {.altitude = 48, .sun = 64, .twilight = true};

// The programs of the passes, compiled once for any number of bakes.
using Bruneton2008Programs = std::map<std::string, gpu::Program>;
Result<std::shared_ptr<const Bruneton2008Programs>> bruneton2008_programs();

class Bruneton2008Bake {
public:
    // `texels`: of the scattering tables, in full precision and channels; `around`: orders of scattering, 1 or more, none extrapolated, and
    // the sizes of the transmittance and of the density. `wavelengths`: one or more, each covered by the atmosphere.
    Bruneton2008Bake(std::shared_ptr<const Bruneton2008Programs> programs, const Atmosphere& atmosphere,
                     std::span<const Wavelength> wavelengths, const Bruneton2008Settings& texels, const BakeSettings& around);
    Bruneton2008Bake(Bruneton2008Bake&&) noexcept;
    Bruneton2008Bake& operator=(Bruneton2008Bake&&) noexcept;
    ~Bruneton2008Bake();

    // How many slices there are, and how many are done: of 149 for four wavelengths and four orders, each is one altitude of a pass.
    std::size_t slices() const;
    std::size_t done() const;
    // Does the next slice; its passes are timed.
    void advance(gpu::PassTimers& timers);

    // The tables, when all slices are done.
    Bruneton2008Textures take() &&;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace airlight::render
