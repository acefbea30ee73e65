// nishita1993: the Earth from the ground and from space; samples at equal steps of density, sunlight from a table.
// [NishitaEtAl1993]
//
//   computes     single scattering by molecules and aerosol where the view meets 64 spheres between which density falls by equal
//                steps; sunlight from optical depths summed where spheres meet 127 cylinders around the planet's axis to the sun;
//                transmittance and aerial perspective; the ground, Lambertian, or the sea
//   leaves out   light scattered more than once, skylight on the ground, gases that absorb (ozone), the sun's mirror image
//   parameters   variant: ground (the atmosphere's albedo) or sea (a smooth sea of pure deep water: the sky's mirror image by
//                Fresnel, and what the water sends back by quasi-single scattering [Gordon1973]; 380 to 700 nm, beyond as at the ends)
//   converted    any atmosphere, to two exponential constituents (two_constituents.h); spheres follow the molecules
//   cost         a table of 12,000 optical depths a pack, 60 ms; 64 samples a direction
//   reference    the text is physics/models/nishita1993.glsl and sea.glsl
#include "models/density_spheres.h"
#include "models/exponential_sky.h"
#include "models/list.h"
#include "models/sea.h"

namespace airlight {

namespace {

constexpr ModelCard card{.key = "nishita1993",
                         .paper = "NishitaEtAl1993",
                         .scattering = "single",
                         .approach = "spheres at equal steps of density, sunlight from a table by sphere and cylinder",
                         .precomputation = "60 ms a pack of 16 wavelengths",
                         .memory = "1.5 MiB a pack",
                         .highest_eye = anywhere,
                         .aerial_perspective = true};

class Nishita1993 : public ExponentialSky {
public:
    Nishita1993(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, bool sea)
        : ExponentialSky(card, atmosphere, std::move(wavelengths)), sea_(sea) {
        for (std::size_t i = 0; i < pack_count(); ++i) spheres_.emplace_back(pack(i));
    }

private:
    f64::ScatteredLight light(std::size_t i, const f64::AirRay& ray) const override { return spheres_[i].light(ray); }

    f64::PhaseSpectrum ground_light(std::size_t i, const f64::AirRay& ground) const override {
        return sea_ ? sea_light(i, ground) : ExponentialSky::ground_light(i, ground);
    }

    f64::PhaseSpectrum sea_light(std::size_t i, const f64::AirRay& ground) const {
        const f64::Number mu = ground.mu, mu_s = ground.mu_s;
        const f64::Length zero = 0.0 * f64::m;
        const f64::AirRay mirrored = f64::air_ray(zero, mu, mu_s, 2.0 * mu * mu_s - ground.nu, f64::distance_in_air(pack(i).air, zero, mu));
        const f64::ScatteredLight sky = spheres_[i].light(mirrored);
        f64::PhaseSpectrum seen = (sky.air * pack(i).air_scattering * air_phase(i, mirrored) +
                                   sky.aerosol * pack(i).aerosol_scattering * aerosol_phase(i, mirrored)) *
                                  f64::sea_reflectance(mu);
        if (mu_s > 0.0) {
            const SeaWater water = sea_water(pack(i).optics.wavelengths);
            seen += f64::sea_water_radiance(water.absorption, water.scattering, mu_s, mu, ground.nu) * sunlight(i, zero, mu_s.value);
        }
        return seen;
    }

    std::vector<DensitySpheres> spheres_;
    bool sea_;
};

Result<std::unique_ptr<Sky>> make(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions& options) {
    const Result<std::string> variant = variant_of(card, options, {"ground", "sea"});
    if (!variant) return variant.error();
    return std::unique_ptr<Sky>(std::make_unique<Nishita1993>(atmosphere, std::move(wavelengths), *variant == "sea"));
}

}  // namespace

Model nishita1993_model() { return {card, make}; }

}  // namespace airlight
