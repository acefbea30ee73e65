// oneil2005: optical lengths by a fitted formula instead of a table, for shaders that have no texture. [ONeil2005]
//
//   computes     single scattering by molecules and aerosol from the ground to space, a sample in the middle of each of four steps
//                of equal length; transmittance and aerial perspective; the ground, Lambertian, lit by the sun alone
//   leaves out   light scattered more than once, skylight on the ground, gases that absorb (ozone)
//   parameters   4 samples, as in the published program of [Bruneton2017] (the paper: 2 to 5); data: a file of `airlight fit oneil2005`
//                or of the paper's constants (oneil2005_data.h), for a planet and scale heights within 1 % of the atmosphere's
//   converted    any atmosphere, to two exponential constituents (two_constituents.h). The paper fits one polynomial of degree four
//                to one planet and one scale height, used for both constituents; here each has its own, fitted when the model is
//                made (scale_function_fit.h). Beyond the horizontal, where the paper lets its polynomial run on, the ray is
//                mirrored at its perigee
//   cost         a fit, milliseconds; 18 exponentials of polynomials a direction and constituent
//   reference    the text is physics/models/oneil2005.glsl
#include <fmt/format.h>

#include <cmath>

#include "models/coefficient_table.h"
#include "models/exponential_sky.h"
#include "models/list.h"
#include "models/oneil2005_data.h"
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

f64::ScaleFunction scale_function(const std::array<double, 5>& c) { return f64::scale_function(c[0], c[1], c[2], c[3], c[4]); }

f64::ONeil2005 fitted_to(const f64::ExponentialAir& air) {
    const auto fit = [&](f64::Length scale_height) {
        return scale_function(fit_scale_function(air.bottom.value * m, air.top.value * m, scale_height.value * m).coefficients);
    };
    return f64::oneil2005(fit(air.air_scale_height), fit(air.aerosol_scale_height));
}

// Fails if a file was fitted to other lengths than an atmosphere's.
Result<Done> same_lengths(const ONeil2005Data& data, std::string_view where, const f64::ExponentialAir& air, std::string_view atmosphere) {
    const struct {
        const char* what;
        double fitted, own;
    } lengths[] = {{"a planet's radius", data.bottom_radius_m, air.bottom.value},
                   {"a scale height of air", data.air.scale_height_m, air.air_scale_height.value},
                   {"a scale height of aerosol", data.aerosol.scale_height_m, air.aerosol_scale_height.value}};
    for (const auto& length : lengths)
        if (!(std::abs(length.fitted / length.own - 1.0) <= 0.01))
            return Error{
                std::string(where),
                fmt::format("is fitted to {} of {:.6g} m: that of {} is {:.6g} m", length.what, length.fitted, atmosphere, length.own),
                "Fit it to this atmosphere, by `airlight fit oneil2005`."};
    return Done{};
}

class ONeil2005 : public ExponentialSky {
public:
    ONeil2005(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const f64::ONeil2005& fit)
        : ExponentialSky(card, atmosphere, std::move(wavelengths)), fit_(fit) {}

private:
    f64::ScatteredLight light(std::size_t i, const f64::AirRay& ray) const override {
        return f64::oneil2005_light(pack(i).air, fit_, ray, samples);
    }

    f64::ONeil2005 fit_;
};

Result<f64::ONeil2005> of_file(const ModelOptions& options, const f64::ExponentialAir& air, std::string_view atmosphere) {
    const Result<CoefficientText> text = coefficient_text(card.key, options.data, "a file of `airlight fit oneil2005`");
    if (!text) return text.error();
    const Result<ONeil2005Data> data = parse_oneil2005(text->text, text->where);
    if (!data) return data.error();
    if (const Result<Done> ok = same_lengths(*data, text->where, air, atmosphere); !ok) return ok.error();
    return f64::oneil2005(scale_function(data->air.coefficients), scale_function(data->aerosol.coefficients));
}

Result<std::unique_ptr<Sky>> make(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions& options) {
    const f64::ExponentialAir air = two_constituents(atmosphere, std::span(wavelengths).first(1)).air;
    const Result<f64::ONeil2005> fit = options.data.empty() ? fitted_to(air) : of_file(options, air, atmosphere.name);
    if (!fit) return fit.error();
    return std::unique_ptr<Sky>(std::make_unique<ONeil2005>(atmosphere, std::move(wavelengths), *fit));
}

}  // namespace

Model oneil2005_model() { return {card, make}; }

}  // namespace airlight
