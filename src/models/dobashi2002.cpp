// dobashi2002: planes before the eye, drawn from the farthest to the nearest and blended by the graphics hardware. [Dobashi2002]
//
//   computes     single scattering by molecules and aerosol from the ground to space: the light between two planes is that of
//                sub-planes, where sunlight is looked up in a texture, and is laid over what lies behind; transmittance and aerial
//                perspective; the ground, Lambertian, lit by the sun alone
//   leaves out   light scattered more than once (the paper adds an ambient term by hand), skylight on the ground, gases that absorb
//                (ozone), shadows of objects in the air (shafts of light), for which the paper is known
//   parameters   30 planes, which crowd towards the eye, 4 sub-planes between two; a texture of 128 sun zenith angles by 64 altitudes
//   converted    any atmosphere, to two exponential constituents (two_constituents.h). Planes are perpendicular to the view's own
//                direction, not to a camera's axis: a view alone has no camera
//   cost         a texture, 30 ms a pack; 120 look-ups a direction
//   reference    the text is physics/models/dobashi2002.glsl
#include <cmath>

#include "core/parallel.h"
#include "models/exponential_sky.h"
#include "models/list.h"

namespace airlight {

namespace {

constexpr int planes = 30;
constexpr int subplanes = 4;
constexpr int cosines = 128;
constexpr int altitudes = 64;

constexpr ModelCard card{.key = "dobashi2002",
                         .paper = "Dobashi2002",
                         .scattering = "single",
                         .approach = "planes blended from far to near, sub-planes, sunlight from a texture",
                         .precomputation = "30 ms a pack of 16 wavelengths",
                         .memory = "1 MiB a pack",
                         .highest_eye = anywhere,
                         .aerial_perspective = true};

using Texture = std::vector<f64::Spectrum>;  // [altitudes][cosines]

Texture sunlight_texture(const f64::ExponentialAir& air) {
    Texture texture(static_cast<std::size_t>(cosines) * altitudes);
    parallel_for(altitudes, [&](std::size_t j) {
        const f64::Length h = f64::altitude_of_coordinate(static_cast<double>(j) / (altitudes - 1), air.top);
        for (int i = 0; i < cosines; ++i) {
            const f64::Number mu = f64::transmittance_cosine_of_coordinate(h, static_cast<double>(i) / (cosines - 1), air.bottom, air.top);
            const f64::Length length = f64::distance_to_top(h, mu, air.bottom, air.top);
            texture[j * cosines + static_cast<std::size_t>(i)] = f64::optical_depth(air, f64::kaneda1991_columns(air, h, mu, length, 48));
        }
    });
    return texture;
}

class Dobashi2002 : public ExponentialSky {
public:
    Dobashi2002(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths)
        : ExponentialSky(card, atmosphere, std::move(wavelengths)) {
        for (std::size_t i = 0; i < pack_count(); ++i) textures_.push_back(sunlight_texture(pack(i).air));
    }

private:
    f64::ScatteredLight light(std::size_t i, const f64::AirRay& ray) const override {
        return f64::dobashi2002_light(pack(i).air, Table2D<f64::Spectrum>(textures_[i], cosines, altitudes), cosines, altitudes, ray,
                                      planes, subplanes);
    }

    std::vector<Texture> textures_;
};

Result<std::unique_ptr<Sky>> make(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions&) {
    return std::unique_ptr<Sky>(std::make_unique<Dobashi2002>(atmosphere, std::move(wavelengths)));
}

}  // namespace

Model dobashi2002_model() { return {card, make}; }

}  // namespace airlight
