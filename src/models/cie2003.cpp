// cie2003: the fifteen standard general skies of the CIE. [CIE2003]
//
//   computes     relative luminance by a gradation from zenith to horizon and an indicatrix around the sun; absolute and spectral as
//                luminance_sky.h says: the standard gives no luminance of the zenith, so the sky's light on level ground is that of
//                the atmosphere, and its spectrum is in every direction
//   leaves out   colour across the sky, the eye's altitude, twilight; the atmosphere does not choose the type
//   parameters   type, 1 (overcast, steep) to 15 (white-blue, turbid): 12, the standard clear sky, unless given
//   cost         small tables for the light on the ground (seconds); two exponentials a direction
//   reference    the text is physics/models/cie2003.glsl, the table data/cie_general_skies.source.md
#include <fmt/format.h>

#include <iterator>

#include "models/list.h"
#include "models/luminance_sky.h"

namespace airlight {

namespace {

constexpr ModelCard card{.key = "cie2003",
                         .paper = "CIE2003",
                         .scattering = "fitted to measured skies",
                         .approach = "gradation and indicatrix of fifteen standard skies; luminance alone",
                         .precomputation = "small tables for the light on the ground: seconds",
                         .memory = "2 MiB a pack of 16 wavelengths",
                         .highest_eye = 0.0 * m,
                         .highest_sun_zenith_deg = 90.0,
                         .highest_view_zenith_deg = 90.0};

struct GeneralSky {
    double a, b, c, d, e;
};
constexpr GeneralSky skies[] = {
#include "cie_general_skies.inc"
};

class Cie2003 : public LuminanceSky {
public:
    Cie2003(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, std::shared_ptr<const TableSky> ground, int type)
        : LuminanceSky(card, atmosphere, std::move(wavelengths), std::move(ground)), sky_(skies[type - 1]) {}

private:
    LuminanceFormula formula(double) const override { return {{sky_.a, sky_.b, sky_.c, sky_.d, sky_.e}, true}; }

    GeneralSky sky_;
};

Result<std::unique_ptr<Sky>> make(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions& options) {
    if (options.cie_type < 1 || options.cie_type > static_cast<int>(std::size(skies)))
        return Error{std::string(card.key), fmt::format("has no sky of type {}: they are 1 to {}", options.cie_type, std::size(skies)),
                     "12 is the clear one."};
    const auto ground = LuminanceSky::ground_light(atmosphere, wavelengths, options);
    if (!ground) return ground.error();
    return std::unique_ptr<Sky>(std::make_unique<Cie2003>(atmosphere, std::move(wavelengths), *ground, options.cie_type));
}

}  // namespace

Model cie2003_model() { return {card, make}; }

}  // namespace airlight
