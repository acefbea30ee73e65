// preetham1999: an analytic model of daylight by turbidity alone. [Preetham1999]
//
//   computes     luminance and chromaticity of the sky by Perez's formula with coefficients linear in turbidity, made
//                spectral as daylight of that chromaticity; sunlight through air, aerosol and ozone
//   leaves out   the eye's altitude, the ground's albedo, twilight, the kind of the aerosol; absorption by oxygen and
//                water vapour beyond 690 nm in the sunlight
//   parameters   turbidity, 1.7 to 10: the atmosphere's own (optical depth of air and aerosol over that of air, 550 nm)
//                unless given; the sun's spectrum scales nothing, for luminances are absolute
//   cost         no precomputation; three of Perez's formulas a direction
//   reference    the text is physics/models/preetham1999.glsl
#include <fmt/format.h>

#include <cmath>

#include "models/list.h"
#include "models/turbidity.h"
#include "optics/aerosol_laws.h"
#include "physics/models/f64.h"
#include "spectrum/daylight.h"

namespace airlight {

namespace {

constexpr double lowest_turbidity = 1.7;
constexpr double highest_turbidity = 10.0;

constexpr ModelCard card{.key = "preetham1999",
                         .paper = "Preetham1999",
                         .scattering = "fitted to all orders",
                         .approach = "Perez's formula for luminance and chromaticity, linear in turbidity",
                         .precomputation = "none",
                         .memory = "none",
                         .highest_eye = 0.0 * m,
                         .highest_sun_zenith_deg = 90.0,
                         .highest_view_zenith_deg = 90.0};

class Preetham1999 : public PublishedSky {
public:
    Preetham1999(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, double turbidity)
        : PublishedSky(card, atmosphere, std::move(wavelengths)), turbidity_(turbidity), daylight_(this->wavelengths()) {}

private:
    std::vector<double> sky_radiance(const View& view) const override {
        const double mu = std::cos(view.view_zenith), nu = view_sun_cosine(view);
        const f64::ColourYxy c = f64::preetham1999_sky(f64::preetham1999(turbidity_, view.sun_zenith), mu, nu);
        std::vector<double> radiance(wavelengths().size());
        daylight_.radiance({c.x.value, c.y.value}, c.luminance.value, radiance);
        return radiance;
    }

    double turbidity_;
    Daylight daylight_;
};

Result<std::unique_ptr<Sky>> make(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions& options) {
    const Result<double> t = turbidity_in(lowest_turbidity, highest_turbidity, card.key, atmosphere, options);
    if (!t) return t.error();
    return std::unique_ptr<Sky>(std::make_unique<Preetham1999>(atmosphere, std::move(wavelengths), *t));
}

}  // namespace

Model preetham1999_model() { return {card, make}; }

}  // namespace airlight
