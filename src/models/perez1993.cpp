// perez1993: the all-weather model of luminance. [Perez1993]
//
//   computes     relative luminance by five coefficients, which follow from the sky's clearness and brightness and the sun's zenith
//                angle; absolute and spectral as luminance_sky.h says
//   leaves out   colour across the sky, the eye's altitude, twilight
//   parameters   clearness (1 without a beam, above 6 for clear skies) and brightness (0 to about 0.6), of the atmosphere unless
//                given: the paper takes them from irradiances of all wavelengths; here they are ratios of illuminances of the beam,
//                of the sky and of the sun above the air, whose other light a description does not hold
//   bounds       two that users of the paper found needful: from clearness 1.065 to 2.8 brightness is at least 0.2, or
//                the fit turns negative; and b is at most 0, for above it the horizon would be infinitely bright. Luminance below zero
//                is zero
//   data         a file of `airlight fit perez` (perez1993_data.h): the formula with coefficients of its own at each wavelength and
//                sun, which give radiance itself, and so have the sky's colours; for the altitude of the eye that it states, and with
//                sunlight through the atmosphere's own air. Clearness and brightness say nothing then
//   cost         small tables for the light on the ground (seconds), none with data; two exponentials a direction, and with data four a
//                wavelength
//   reference    the text is physics/models/perez.glsl and perez1993.glsl, the table data/perez1993.source.md
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "models/axis.h"
#include "models/coefficient_table.h"
#include "models/list.h"
#include "models/luminance_sky.h"
#include "models/perez1993_data.h"
#include "spectrum/colour_weights.h"

namespace airlight {

namespace {

constexpr ModelCard card{.key = "perez1993",
                         .paper = "Perez1993",
                         .scattering = "fitted to measured skies",
                         .approach = "five-parameter luminance by clearness and brightness of the sky",
                         .precomputation = "small tables for the light on the ground: seconds",
                         .memory = "4 MiB",
                         .highest_eye = 0.0 * m,
                         .highest_sun_zenith_deg = 90.0,
                         .highest_view_zenith_deg = 90.0};

struct Class {
    double highest_clearness;
    double x[5][4];  // of a, b, c, d, e
};
constexpr Class classes[] = {
#include "perez1993.inc"
};

// [Perez1993, eq. 6 to 8]
f64::PerezCoefficients coefficients(double clearness, double brightness, double z) {
    const Class& c =
        *std::find_if(std::begin(classes), std::end(classes) - 1, [&](const Class& k) { return clearness < k.highest_clearness; });
    const double delta = clearness >= 1.065 && clearness < 2.8 ? std::max(0.2, brightness) : brightness;
    const auto of = [&](int i) { return c.x[i][0] + c.x[i][1] * z + delta * (c.x[i][2] + c.x[i][3] * z); };
    f64::PerezCoefficients k{of(0), std::min(0.0, of(1)), of(2), of(3), of(4)};
    if (&c == classes) {
        k.c = std::exp(std::pow(delta * (c.x[2][0] + c.x[2][1] * z), c.x[2][2])) - c.x[2][3];
        k.d = -std::exp(delta * (c.x[3][0] + c.x[3][1] * z)) + c.x[3][2] + delta * c.x[3][3];
    }
    return k;
}

// What the formula of a sun follows from.
struct Weather {
    double clearness, brightness;
};

// The sky of a file.
class FittedPerez1993 : public PublishedSky {
public:
    FittedPerez1993(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, Perez1993Data data, Reference air)
        : PublishedSky(card_of(data), atmosphere, std::move(wavelengths)), data_(std::move(data)), air_(std::move(air)) {}

    Result<std::vector<double>> transmittance(Length altitude, double view_zenith, Length distance) const override {
        if (const Result<Done> ok = within_range({altitude, view_zenith, 0.0, 0.0}); !ok) return ok.error();
        return air_.transmittance(altitude, view_zenith, distance);
    }

private:
    static ModelCard card_of(const Perez1993Data& data) {
        ModelCard c = card;
        c.lowest_eye = c.highest_eye = data.altitude_m * m;
        c.highest_sun_zenith_deg = data.sun_zeniths_deg.back();
        return c;
    }

    std::vector<double> sky_radiance(const View& view) const override {
        std::vector<double> radiance;
        for (const Wavelength wavelength : wavelengths())
            radiance.push_back(
                place_on(data_.wavelengths_nm, wavelength.in(nm)).between([&](std::size_t w) { return data_.radiance(w, view); }));
        return radiance;
    }

    Perez1993Data data_;
    Reference air_;
};

class Perez1993 : public LuminanceSky {
public:
    // `visible` tells illuminances; none if the user gave both.
    Perez1993(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, std::shared_ptr<const TableSky> ground,
              std::shared_ptr<const TableSky> visible, const ModelOptions& options)
        : LuminanceSky(card, atmosphere, std::move(wavelengths), std::move(ground)),
          visible_(std::move(visible)),
          weights_(WavelengthGrid::standard(), atmosphere.sun.irradiance),
          given_clearness_(options.clearness),
          given_brightness_(options.brightness) {}

private:
    LuminanceFormula formula(double sun_zenith) const override {
        const Weather w = weather(sun_zenith);
        return {coefficients(w.clearness, w.brightness, sun_zenith), false};
    }

    Weather weather(double z) const {
        if (!visible_) return {*given_clearness_, *given_brightness_};
        // A hair above the horizon, where a beam still has a direction.
        const double zenith = std::min(z, 0.5 * pi - 1e-4);
        const IrradianceEstimate light = *visible_->irradiance(0.0 * m, zenith);
        std::vector<double> sunlight;
        for (const Wavelength w : visible_->wavelengths()) sunlight.push_back(atmosphere().sun.irradiance.at(w).in(W_per_m2_nm));
        const double diffuse = illuminance_of(light.diffuse_W_m2_nm);
        const double beam = illuminance_of(light.direct_W_m2_nm) / std::cos(zenith);
        return {given_clearness_.value_or(f64::sky_clearness(beam, diffuse, zenith).value),
                given_brightness_.value_or(f64::sky_brightness(diffuse, illuminance_of(sunlight), zenith).value)};
    }

    double illuminance_of(const std::vector<double>& spectrum) const { return weights_.to_xyz(std::span<const double>(spectrum)).y; }

    std::shared_ptr<const TableSky> visible_;
    ColourWeights weights_;
    std::optional<double> given_clearness_, given_brightness_;
};

Result<Done> check(const ModelOptions& options) {
    if (!options.data.empty() && (options.clearness || options.brightness))
        return Error{std::string(card.key), "takes no clearness and no brightness beside a fitted file", ""};
    if (options.clearness && !(*options.clearness >= 1.0))
        return Error{std::string(card.key), fmt::format("does not answer a clearness of {:g}: it is 1 or more", *options.clearness), ""};
    if (options.brightness && !(*options.brightness > 0.0 && *options.brightness <= 1.0))
        return Error{std::string(card.key),
                     fmt::format("does not answer a brightness of {:g}: it is above 0 and at most 1", *options.brightness), ""};
    return Done{};
}

Result<std::unique_ptr<Sky>> make_fitted(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions& options) {
    const Result<CoefficientText> text = coefficient_text(card.key, options.data, "a file of `airlight fit perez`");
    if (!text) return text.error();
    Result<Perez1993Data> data = parse_perez1993(text->text, text->where);
    if (!data) return data.error();
    if (const Result<Done> ok = data_covers(data->wavelengths_nm, wavelengths, card.key); !ok) return ok.error();
    Result<Reference> air = Reference::of(atmosphere, wavelengths);
    if (!air) return air.error();
    return std::unique_ptr<Sky>(std::make_unique<FittedPerez1993>(atmosphere, std::move(wavelengths), std::move(*data), std::move(*air)));
}

Result<std::unique_ptr<Sky>> make(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions& options) {
    if (const Result<Done> ok = check(options); !ok) return ok.error();
    if (!options.data.empty()) return make_fitted(atmosphere, std::move(wavelengths), options);
    const auto ground = LuminanceSky::ground_light(atmosphere, wavelengths, options);
    if (!ground) return ground.error();
    std::shared_ptr<const TableSky> visible;
    if (!options.clearness || !options.brightness) {
        const WavelengthGrid grid = WavelengthGrid::standard();
        const std::vector<Wavelength> standard(grid.begin(), grid.end());
        const auto light = wavelengths == standard ? ground : LuminanceSky::ground_light(atmosphere, standard, options);
        if (!light) return light.error();
        visible = *light;
    }
    return std::unique_ptr<Sky>(std::make_unique<Perez1993>(atmosphere, std::move(wavelengths), *ground, std::move(visible), options));
}

}  // namespace

Model perez1993_model() { return {card, make}; }

}  // namespace airlight
