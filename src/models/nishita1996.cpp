// nishita1996: the sky with light scattered several times, gathered in voxels from eight directions. [NishitaEtAl1996]
//
//   computes     single scattering as nishita1993; light scattered before, kept at 24 altitudes for 48 zenith angles of the sun from
//                eight directions (up, down, level to and from the sun, to and from the sun, and across it), pass by pass; towards the
//                eye, as towards the next pass, each direction's light by the integral of the phase functions over what is nearest
//                to it; the ground, Lambertian, lit by the sun and, in passes after the first, by the voxels; from the ground to
//                space; transmittance and aerial perspective
//   leaves out   gases that absorb (ozone); light out of the plane of sun and zenith is taken for that of the nearest of the eight
//   parameters   variant: 2 (the second order, as in the paper's pictures), 1, 3 or 4
//   range        any eye; the sun to 90 degrees from the zenith, and where a view from space enters the air: beyond, one direction
//                towards the glow over the horizon stands for an eighth of the sphere (at 99 degrees ten times too bright)
//   converted    any atmosphere, to two exponential constituents (two_constituents.h). The paper's voxels fill a box around the eye
//                for one sun; on a round planet a column of them for each sun stands for all. In the first pass a direction has the
//                mean of the phase functions over what it stands for: their value in the midst of the sun's peak, times an eighth
//                of the sphere, would scatter more light than there is
//   cost         0.3 s a pass and pack on one core; a direction scatters over 512 directions and 32 samples of 8 look-ups
//   reference    the text is physics/models/nishita1996.glsl and nishita1993.glsl
//
// Nearer to a measured sky than its published program (12.2 against 18.2): tests/truth/models_truth_test.cpp says why.
#include "models/exponential_sky.h"
#include "models/light_voxels.h"
#include "models/list.h"

namespace airlight {

namespace {

constexpr ModelCard card{.key = "nishita1996",
                         .paper = "NishitaEtAl1996",
                         .scattering = "two (to four) orders",
                         .approach = "voxels of light from eight directions, spheres at equal steps of density",
                         .precomputation = "0.3 s an order and pack of 16 wavelengths",
                         .memory = "2.6 MiB a pack",
                         .highest_eye = anywhere,
                         .highest_sun_zenith_deg = 90.0,
                         .aerial_perspective = true,
                         .refused = "views that enter the air where the sun is down"};

class Nishita1996 : public ExponentialSky {
public:
    Nishita1996(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, int orders)
        : ExponentialSky(card, atmosphere, std::move(wavelengths)) {
        spheres_.reserve(pack_count());
        for (std::size_t i = 0; i < pack_count(); ++i) {
            spheres_.emplace_back(pack(i));
            voxels_.emplace_back(pack(i), spheres_[i], orders);
        }
    }

private:
    Result<Done> answerable(const View& view) const override {
        const std::optional<f64::AirRay> ray = air_ray_of(pack(0), view);
        constexpr double hair = 1e-9;
        if (!ray || ray->mu_s > -hair) return Done{};
        return Error{name(), "does not answer views that enter the air with the sun beyond 90 deg from the zenith",
                     "`airlight models` shows the range of each model."};
    }

    f64::ScatteredLight light(std::size_t i, const f64::AirRay& ray) const override { return spheres_[i].light(ray); }
    f64::PhaseSpectrum more_light(std::size_t i, const f64::AirRay& ray) const override { return voxels_[i].light(ray); }
    f64::PhaseSpectrum ground_light(std::size_t i, const f64::AirRay& ground) const override {
        return ExponentialSky::ground_light(i, ground) + pack(i).optics.ground_albedo * voxels_[i].on_ground(ground.mu_s.value);
    }

    std::vector<DensitySpheres> spheres_;
    std::vector<LightVoxels> voxels_;
};

Result<std::unique_ptr<Sky>> make(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions& options) {
    const Result<std::string> variant = variant_of(card, options, {"2", "1", "3", "4"});
    if (!variant) return variant.error();
    return std::unique_ptr<Sky>(std::make_unique<Nishita1996>(atmosphere, std::move(wavelengths), variant->front() - '0'));
}

}  // namespace

Model nishita1996_model() { return {card, make}; }

}  // namespace airlight
