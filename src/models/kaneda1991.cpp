// kaneda1991: the first sky of exponential density, marched along the view and, from each sample, towards the sun. [Kaneda1991]
//
//   computes     single scattering by molecules and aerosol on a spherical planet, from the ground to space; transmittance and
//                aerial perspective along the same ray; the ground, Lambertian, lit by the sun alone
//   leaves out   light scattered more than once, skylight on the ground, gases that absorb (ozone)
//   parameters   48 samples along a piece of the view, 32 along a piece towards the sun; both crowd towards the lower end, for steps
//                of equal length pass over the aerosol
//   converted    any atmosphere, to two exponential constituents (two_constituents.h)
//   cost         no precomputation; a thousand exponentials a direction and constituent
//   reference    the text is physics/models/kaneda1991.glsl
#include "models/exponential_sky.h"
#include "models/list.h"

namespace airlight {

namespace {

constexpr int view_samples = 48;
constexpr int sun_samples = 32;

constexpr ModelCard card{.key = "kaneda1991",
                         .paper = "Kaneda1991",
                         .scattering = "single",
                         .approach = "marched along the view and towards the sun, exponential densities",
                         .precomputation = "none",
                         .memory = "none",
                         .highest_eye = anywhere,
                         .aerial_perspective = true};

class Kaneda1991 : public ExponentialSky {
public:
    Kaneda1991(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths)
        : ExponentialSky(card, atmosphere, std::move(wavelengths)) {}

private:
    f64::ScatteredLight light(std::size_t i, const f64::AirRay& ray) const override {
        return f64::kaneda1991_light(pack(i).air, ray, view_samples, sun_samples);
    }
};

Result<std::unique_ptr<Sky>> make(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions&) {
    return std::unique_ptr<Sky>(std::make_unique<Kaneda1991>(atmosphere, std::move(wavelengths)));
}

}  // namespace

Model kaneda1991_model() { return {card, make}; }

}  // namespace airlight
