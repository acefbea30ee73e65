// hipiny2006: a parametric sky by altitude, for what a flight sees. [Hipiny2006]
//
//   computes     luminance and chromaticity by Perez's formula, with coefficients that a fit gives for the sun's zenith angle, the
//                turbidity and five reference altitudes from the ground to 30 km; between altitudes colours are interpolated as
//                exp(-altitude / 8 km), between suns and turbidities evenly; made spectral as daylight of the colour
//   aerial perspective  the thesis' single equation: a point's light fades with the way to it, and the colour of the sky patch that the
//                line through it meets comes in its place. A line below the horizon has the horizon's patch on its side. The fading
//                is that of molecules and of an Angstrom aerosol whose densities fall with 8 km and 1.2 km; the planet is flat
//   leaves out   the ground's albedo, twilight, views below the horizon; the published coefficients, which the thesis does not print
//   parameters   data: a file of `airlight fit hipiny2006` (hipiny2006_data.h), or else the fit that is shipped, to clear air over
//                land (data/hipiny2006_fit.source.md: turbidity 1.3 to 8, luminance 5.5 % from the truth on the ground, below 1 % from
//                2 km up); turbidity in the file's range, the atmosphere's own unless given (a file of one turbidity takes none); the
//                eye and the sun in the file's range
//   cost         no precomputation; twenty-four of Perez's formulas a direction
//   reference    the text is physics/models/hipiny2006.glsl
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "models/axis.h"
#include "models/coefficient_table.h"
#include "models/hipiny2006_data.h"
#include "models/list.h"
#include "models/turbidity.h"
#include "optics/aerosol_laws.h"
#include "optics/rayleigh.h"
#include "spectrum/daylight.h"

namespace airlight {

namespace {

constexpr ModelCard card{.key = "hipiny2006",
                         .paper = "Hipiny2006",
                         .scattering = "fitted to all orders",
                         .approach = "Perez's formula for luminance and chromaticity at five altitudes",
                         .precomputation = "none",
                         .memory = "144 B an altitude, turbidity and sun",
                         .highest_eye = 30.0 * km,
                         .highest_sun_zenith_deg = 90.0,
                         .highest_view_zenith_deg = 90.0,
                         .aerial_perspective = true};

constexpr double scale_height_m = 8000.0;
constexpr double aerosol_height_m = 1200.0;

// The card with what the file can answer.
ModelCard card_of(const Hipiny2006Data& data) {
    ModelCard c = card;
    c.lowest_eye = data.altitudes_m.front() * m;
    c.highest_eye = data.altitudes_m.back() * m;
    c.highest_sun_zenith_deg = data.sun_zeniths_deg.back();
    return c;
}

class Hipiny2006 : public PublishedSky {
public:
    Hipiny2006(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, Hipiny2006Data data, double turbidity)
        : PublishedSky(card_of(data), atmosphere, std::move(wavelengths)),
          data_(std::move(data)),
          turbidity_(turbidity),
          daylight_(this->wavelengths()) {}

    Result<std::vector<double>> transmittance(Length altitude, double view_zenith, Length distance) const override {
        if (const Result<Done> ok = within_range({altitude, 0.0, 0.0, 0.0}); !ok) return ok.error();
        if (const Result<Done> ok = check_view(altitude, view_zenith, 0.0, 0.0); !ok) return ok.error();
        return transparency(altitude, view_zenith, distance);
    }

    Result<AerialPerspective> aerial_perspective(const View& view, Length distance) const override {
        View patch = view;
        patch.view_zenith = std::min(view.view_zenith, 0.5 * pi);
        if (const Result<Done> ok = within_range(patch); !ok) return ok.error();
        if (const Result<Done> ok = check_view(view.altitude, view.view_zenith, view.sun_zenith, view.relative_azimuth); !ok)
            return ok.error();
        AerialPerspective seen{transparency(view.altitude, view.view_zenith, distance), sky_radiance(patch)};
        for (std::size_t w = 0; w < seen.transmittance.size(); ++w) seen.inscattered_W_m2_sr_nm[w] *= 1.0 - seen.transmittance[w];
        return seen;
    }

private:
    std::vector<double> sky_radiance(const View& view) const override {
        const f64::Number mu = std::max(0.0, std::cos(view.view_zenith)), nu = view_sun_cosine(view);
        const AxisPlace h = place_on(data_.altitudes_m, view.altitude.value);
        const auto at = [&](std::size_t altitude) { return colour(altitude, view.sun_zenith, mu, nu); };
        const auto metres = [](double x) { return f64::Length::of(x); };
        f64::ColourYxy c = at(h.low);
        if (h.high != h.low && h.weight > 0.0)
            c = f64::mix_colours(c, at(h.high),
                                 f64::hipiny2006_weight(metres(view.altitude.value), metres(data_.altitudes_m[h.low]),
                                                        metres(data_.altitudes_m[h.high]), metres(scale_height_m)));
        std::vector<double> radiance(wavelengths().size());
        daylight_.radiance({c.x.value, c.y.value}, std::max(0.0, c.luminance.value), radiance);
        return radiance;
    }

    // At a reference altitude.
    f64::ColourYxy colour(std::size_t altitude, double sun_zenith, f64::Number mu, f64::Number nu) const {
        const AxisPlace t = place_on(data_.turbidities, turbidity_);
        const auto of = [&](std::size_t turbidity) {
            return hipiny2006_colour(data_, altitude, turbidity, sun_zenith, mu.value, nu.value);
        };
        return t.low == t.high ? of(t.low) : f64::mix_colours(of(t.low), of(t.high), t.weight);
    }

    // Of a way that ends at its distance, or on the ground.
    std::vector<double> transparency(Length altitude, double view_zenith, Length distance) const {
        const double mu = std::cos(view_zenith);
        double way = std::min(distance.value, 1e9);
        if (mu < 0.0) way = std::min(way, altitude.value / -mu);
        const auto column_m = [&](double height) {
            return way * std::exp(-altitude.value / height) * f64::layer_share(way * mu / height).value;
        };
        std::vector<double> seen;
        for (const Wavelength w : wavelengths()) {
            const double molecules = rayleigh_optical_depth(w) / scale_height_m;
            const double aerosol = optical_depth(preetham_angstrom_law(turbidity_), w) / aerosol_height_m;
            seen.push_back(std::exp(-molecules * column_m(scale_height_m) - aerosol * column_m(aerosol_height_m)));
        }
        return seen;
    }

    Hipiny2006Data data_;
    double turbidity_;
    Daylight daylight_;
};

Result<std::unique_ptr<Sky>> make(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions& options) {
    const Result<CoefficientText> text = coefficient_text(card.key, options.data, "a file of `airlight fit hipiny2006`");
    if (!text) return text.error();
    Result<Hipiny2006Data> data = parse_hipiny2006(text->text, text->where);
    if (!data) return data.error();
    double t = data->turbidities.front();
    if (data->turbidities.size() > 1) {
        const Result<double> asked = turbidity_in(data->turbidities.front(), data->turbidities.back(), card.key, atmosphere, options);
        if (!asked) return asked.error();
        t = *asked;
    }
    return std::unique_ptr<Sky>(std::make_unique<Hipiny2006>(atmosphere, std::move(wavelengths), std::move(*data), t));
}

}  // namespace

Model hipiny2006_model() { return {card, make}; }

}  // namespace airlight
