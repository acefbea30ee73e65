// preetham1999: an analytic model of daylight by turbidity alone. [Preetham1999]
//
//   computes     luminance and chromaticity of the sky by Perez's formula with coefficients linear in turbidity, made
//                spectral as daylight of that chromaticity; sunlight through air, aerosol and 0.35 cm of ozone; aerial
//                perspective through two layers, molecules (scale height 8.80 km) and haze (1.20 km), as if the ground were flat
//   leaves out   the eye's altitude, the ground's albedo, twilight, the kind of the aerosol; absorption by oxygen and
//                water vapour beyond 690 nm in the sunlight; light of the ground in the aerial perspective. The paper's table of the
//                haze's phase function is Henyey and Greenstein's here, with g = 0.76
//   parameters   turbidity, 1.7 to 10: the atmosphere's own (optical depth of air and aerosol over that of air, 550 nm)
//                unless given; the sun's spectrum scales nothing, for luminances are absolute
//   data         a file of `airlight fit preetham` (preetham1999_data.h): coefficients of another air, for the turbidities and the
//                altitude of the eye that it states (of one turbidity it takes none). Sunlight and transmittance are then those of the
//                atmosphere's own air, and there is no aerial perspective, whose two layers are the Earth's
//   cost         no precomputation; three of Perez's formulas a direction; an aerial perspective sums 128 directions of the sky.
//                In pictures: preetham1999_rgb.h
//   transmittance  over 1,000 km or more the whole air's, as of sunlight; over less that of the two layers, which differ by some percent
//   reference    the text is physics/models/preetham1999.glsl and preetham1999_air.glsl
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "atmosphere/constituents.h"
#include "core/quadrature.h"
#include "models/coefficient_table.h"
#include "models/list.h"
#include "models/preetham1999_data.h"
#include "models/turbidity.h"
#include "optics/aerosol_laws.h"
#include "optics/gases.h"
#include "optics/rayleigh.h"
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
                         .highest_view_zenith_deg = 90.0,
                         .aerial_perspective = true};

// [Preetham1999, sec. 5]
constexpr Length molecules_height = 1.0 / 0.1136 * km;
constexpr Length haze_height = 1.0 / 0.8333 * km;
constexpr double haze_asymmetry = 0.76;

constexpr Length through_the_air = 1000.0 * km;

// What does not depend on the direction, at one wavelength.
struct Air {
    double wavelength_um;
    double ozone_depth;      // of 0.35 cm
    double molecules, haze;  // scattering on the ground, per metre
};

std::vector<Air> air_of(std::span<const Wavelength> wavelengths, double turbidity) {
    constexpr double ozone_per_m2 = 350.0 * dobson_unit_per_m2;
    const SpectrumOf<Area> ozone = ozone_cross_section(223.0);
    std::vector<Air> all;
    for (const Wavelength w : wavelengths)
        all.push_back({w.in(1000.0 * nm), ozone.at(w).value * ozone_per_m2,
                       (rayleigh_cross_section_of_air(w) * standard_number_density).value, preetham_haze_scattering(turbidity, w).value});
    return all;
}

// How a way from the ground rises through the two layers, in scale heights.
struct Rise {
    double length_m, molecules, haze;
};
Rise rise(double view_zenith, Length distance) {
    const double height = std::max(0.0, std::cos(view_zenith)) * distance.value;
    return {distance.value, height / molecules_height.value, height / haze_height.value};
}

class Preetham1999 : public PublishedSky {
public:
    Preetham1999(const ModelCard& range, const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, double turbidity)
        : PublishedSky(range, atmosphere, std::move(wavelengths)),
          turbidity_(turbidity),
          daylight_(this->wavelengths()),
          air_(air_of(this->wavelengths(), turbidity)) {}

    Result<std::vector<double>> transmittance(Length altitude, double view_zenith, Length distance) const override {
        if (const Result<Done> ok = within_range({altitude, view_zenith, 0.0, 0.0}); !ok) return ok.error();
        if (!(distance >= through_the_air)) return between(rise(view_zenith, distance));
        return sunlight(view_zenith);
    }

    Result<AerialPerspective> aerial_perspective(const View& view, Length distance) const override {
        if (const Result<Done> ok = within_range(view); !ok) return ok.error();
        const Rise way = rise(view.view_zenith, std::min(distance, through_the_air));
        AerialPerspective seen{between(way), std::vector<double>(air_.size())};
        const std::vector<Scattered> light = scattered(view);
        for (std::size_t w = 0; w < air_.size(); ++w) {
            const double m = air_[w].molecules * way.length_m, h = air_[w].haze * way.length_m;
            seen.inscattered_W_m2_sr_nm[w] = light[w].molecules * m * f64::inscattered_share(m, way.molecules, h, way.haze).value +
                                             light[w].haze * h * f64::inscattered_share(h, way.haze, m, way.molecules).value;
        }
        return seen;
    }

protected:
    double turbidity() const { return turbidity_; }

    // The formula for a sun.
    virtual f64::Preetham1999 formula(double sun_zenith) const { return f64::preetham1999(turbidity_, sun_zenith); }

private:
    // Light that turns towards the eye, over the scattering coefficient.
    struct Scattered {
        double molecules = 0.0, haze = 0.0;

        void add(double light, double nu) {
            molecules += light * f64::rayleigh_phase(nu).value;
            haze += light * f64::henyey_greenstein_phase(haze_asymmetry, nu).value;
        }
    };

    std::vector<double> sunlight(double zenith) const {
        const f64::Number mass = f64::relative_air_mass(zenith);
        std::vector<double> seen;
        for (const Air& a : air_) seen.push_back(f64::preetham1999_sunlight(mass, a.wavelength_um, turbidity_, a.ozone_depth).value);
        return seen;
    }

    std::vector<double> between(const Rise& way) const {
        std::vector<double> seen;
        for (const Air& a : air_)
            seen.push_back(std::exp(-way.length_m *
                                    (a.molecules * f64::layer_share(way.molecules).value + a.haze * f64::layer_share(way.haze).value)));
        return seen;
    }

    // From the sun and from 8 x 16 directions of the sky.
    std::vector<Scattered> scattered(const View& view) const {
        std::vector<Scattered> light(air_.size());
        const std::vector<double> beam = sunlight(view.sun_zenith);
        for (std::size_t w = 0; w < light.size(); ++w) light[w].add(beam[w] * solar_irradiance_W_m2_nm()[w], view_sun_cosine(view));
        static const GaussRule cosines = gauss_rule(8, 0.0, 1.0);
        for (std::size_t i = 0; i < cosines.nodes.size(); ++i)
            for (int j = 0; j < 16; ++j) {
                const double zenith = std::acos(cosines.nodes[i]), azimuth = (j + 0.5) * pi / 8.0;
                const std::vector<double> sky = sky_radiance({view.altitude, zenith, view.sun_zenith, azimuth});
                const double nu = view_sun_cosine({view.altitude, view.view_zenith, zenith, view.relative_azimuth - azimuth});
                for (std::size_t w = 0; w < light.size(); ++w) light[w].add(sky[w] * cosines.weights[i] * pi / 8.0, nu);
            }
        return light;
    }

    std::vector<double> sky_radiance(const View& view) const override {
        const double mu = std::cos(view.view_zenith), nu = view_sun_cosine(view);
        const f64::ColourYxy c = f64::preetham1999_sky(formula(view.sun_zenith), mu, nu);
        std::vector<double> radiance(wavelengths().size());
        daylight_.radiance({c.x.value, c.y.value}, std::max(0.0, c.luminance.value), radiance);
        return radiance;
    }

    double turbidity_;
    Daylight daylight_;
    std::vector<Air> air_;
};

// The sky of a file.
class FittedPreetham1999 : public Preetham1999 {
public:
    FittedPreetham1999(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const Preetham1999Data& data, double turbidity,
                       Reference air)
        : Preetham1999(card_of(data), atmosphere, std::move(wavelengths), turbidity), data_(data), air_(std::move(air)) {}

    Result<std::vector<double>> transmittance(Length altitude, double view_zenith, Length distance) const override {
        if (const Result<Done> ok = within_range({altitude, view_zenith, 0.0, 0.0}); !ok) return ok.error();
        return air_.transmittance(altitude, view_zenith, distance);
    }

    Result<AerialPerspective> aerial_perspective(const View&, Length) const override {
        return Error{name(), "has no aerial perspective with a fitted file", "Leave the file out, if the air is the Earth's."};
    }

private:
    static ModelCard card_of(const Preetham1999Data& data) {
        ModelCard c = card;
        c.lowest_eye = c.highest_eye = data.altitude_m * m;
        return c;
    }

    f64::Preetham1999 formula(double sun_zenith) const override { return in_text(data_, turbidity(), sun_zenith); }

    Preetham1999Data data_;
    Reference air_;
};

Result<std::unique_ptr<Sky>> make_fitted(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions& options) {
    const Result<CoefficientText> text = coefficient_text(card.key, options.data, "a file of `airlight fit preetham`");
    if (!text) return text.error();
    const Result<Preetham1999Data> data = parse_preetham1999(text->text, text->where);
    if (!data) return data.error();
    double t = data->lowest_turbidity;
    if (data->highest_turbidity > t) {
        const Result<double> asked = turbidity_in(t, data->highest_turbidity, card.key, atmosphere, options);
        if (!asked) return asked.error();
        t = *asked;
    }
    Result<Reference> air = Reference::of(atmosphere, wavelengths);
    if (!air) return air.error();
    return std::unique_ptr<Sky>(std::make_unique<FittedPreetham1999>(atmosphere, std::move(wavelengths), *data, t, std::move(*air)));
}

Result<std::unique_ptr<Sky>> make(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions& options) {
    if (!options.data.empty()) return make_fitted(atmosphere, std::move(wavelengths), options);
    const Result<double> t = turbidity_in(lowest_turbidity, highest_turbidity, card.key, atmosphere, options);
    if (!t) return t.error();
    return std::unique_ptr<Sky>(std::make_unique<Preetham1999>(card, atmosphere, std::move(wavelengths), *t));
}

}  // namespace

Model preetham1999_model() { return {card, make}; }

}  // namespace airlight
