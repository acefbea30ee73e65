// oneil2005: optical lengths by a fitted formula instead of a table, for shaders that have no texture. [ONeil2005]
//
//   computes     single scattering by molecules and aerosol from the ground to space, a sample in the middle of each of four steps
//                of equal length; transmittance and aerial perspective; the ground, Lambertian, lit by the sun alone
//   leaves out   light scattered more than once, skylight on the ground, gases that absorb (ozone)
//   parameters   4 samples, as in the published program of [Bruneton2017] (the paper: 2 to 5)
//   converted    any atmosphere, to two exponential constituents (two_constituents.h). The paper fits one polynomial of degree four
//                to one planet and one scale height, used for both constituents; here each has its own, fitted when the model is
//                made (scale_function_fit.h). Beyond the horizontal, where the paper lets its polynomial run on, the ray is
//                mirrored at its perigee
//   cost         a fit, milliseconds; 18 exponentials of polynomials a direction and constituent
//   reference    the text is physics/models/oneil2005.glsl
#include "models/exponential_sky.h"
#include "models/list.h"
#include "models/scale_function_fit.h"

namespace airlight {

namespace {

constexpr int samples = 4;

constexpr ModelCard card{.key = "oneil2005",
                         .paper = "ONeil2005",
                         .scattering = "single",
                         .approach = "four samples, optical lengths by a fitted exponential of a polynomial",
                         .precomputation = "a fit, milliseconds",
                         .memory = "ten coefficients",
                         .highest_eye = anywhere,
                         .aerial_perspective = true};

f64::ScaleFunction scale_function(const f64::ExponentialAir& air, f64::Length scale_height) {
    const auto c = fit_scale_function(air.bottom.value * m, air.top.value * m, scale_height.value * m).coefficients;
    return f64::scale_function(c[0], c[1], c[2], c[3], c[4]);
}

class ONeil2005 : public ExponentialSky {
public:
    ONeil2005(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths)
        : ExponentialSky(card, atmosphere, std::move(wavelengths)),
          fit_(f64::oneil2005(scale_function(pack(0).air, pack(0).air.air_scale_height),
                              scale_function(pack(0).air, pack(0).air.aerosol_scale_height))) {}

private:
    f64::ScatteredLight light(std::size_t i, const f64::AirRay& ray) const override {
        return f64::oneil2005_light(pack(i).air, fit_, ray, samples);
    }

    f64::ONeil2005 fit_;
};

Result<std::unique_ptr<Sky>> make(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions&) {
    return std::unique_ptr<Sky>(std::make_unique<ONeil2005>(atmosphere, std::move(wavelengths)));
}

}  // namespace

Model oneil2005_model() { return {card, make}; }

}  // namespace airlight
