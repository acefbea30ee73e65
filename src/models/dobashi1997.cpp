// dobashi1997: the sky as a short series of functions, fitted to the skies of a slower model. [Dobashi1997; Lopes2015, sec. 3.4]
//
//   computes     radiance from the zenith to the horizon in one of the paper's three forms: `cosines` of the azimuth, for bands of one
//                elevation, as many in each as bring the rest of its square below 1e-4; `samples`, a grid of directions without a
//                function; `harmonics` on the sphere, up to degree 20. Linear between two bands, two azimuths of the grid, two suns
//   leaves out   what its source does: the paper's source is single scattering [Kaneda1991], as here unless a file is given;
//                `airlight fit dobashi1997` takes all orders, another altitude or another demand. Views below the horizon, twilight.
//                The error is bounded in the bands, at the suns of the series: between two suns, which are 5 deg apart and
//                2 to 3 near the horizon, the glow around the sun stands at both
//   parameters   variant: cosines (default), samples, harmonics; data: a file of `airlight fit dobashi1997` (dobashi1997_data.h), for
//                the altitude of the eye that it states. 21 suns, 21 bands, 64 azimuths sampled; 36 steps of azimuth in the grid
//   converted    harmonics need a whole sphere: the sky below the horizon is its mirror image, so degree and order are even together.
//                In [Lopes2015] eq. 46 counts the ends of its rule fully, eq. 48 lacks the weights' squares, and eq. 50 has a minus
//                before its second half: here the rule is one of midpoints, Parseval's equation has squares, and a mean has a plus.
//                Sunlight on the ground is seen through the atmosphere's own air
//   cost         28,000 directions of the source before the first answer; then a sum of cosines for each of two bands and two suns: in
//                domes for two bands alone
//   reference    the text is physics/models/dobashi1997.glsl
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "models/axis.h"
#include "models/coefficient_table.h"
#include "models/direction_batch.h"
#include "models/dobashi1997_series.h"
#include "models/list.h"

namespace airlight {

namespace {

constexpr ModelCard card{.key = "dobashi1997",
                         .paper = "Dobashi1997",
                         .scattering = "single, or that of its file",
                         .approach = "bands of the sky as series of cosines, a grid, or spherical harmonics",
                         .precomputation = "28,000 directions of kaneda1991: seconds",
                         .memory = "20 to 50 KiB a wavelength",
                         .highest_eye = 0.0 * m,
                         .highest_sun_zenith_deg = 90.0,
                         .highest_view_zenith_deg = 90.0};

ModelCard card_of(const Dobashi1997Data& data) {
    ModelCard c = card;
    c.lowest_eye = c.highest_eye = data.altitude_m * m;
    c.highest_sun_zenith_deg = data.sun_zeniths_deg.back();
    return c;
}

// One sun, between those of the series.
class Dobashi1997Dome : public SkyDome {
public:
    Dobashi1997Dome(const Dobashi1997Data& data, std::vector<AxisPlace> mixes, double sun_zenith)
        : basis_(data.basis), bands_(data.bands), mixes_(std::move(mixes)) {
        for (std::size_t w = 0; w < data.wavelengths_nm.size(); ++w) skies_.push_back(data.between_suns(w, sun_zenith));
    }

    void radiance(double view_zenith, double relative_azimuth, std::span<float> radiance) const override {
        const Direction direction{view_zenith, relative_azimuth};
        std::fill(radiance.begin(), radiance.end(), 0.0f);
        if (below_horizon(direction)) return;
        const SeriesPlace place(basis_, bands_, direction);
        for (std::size_t w = 0; w < mixes_.size(); ++w)
            radiance[w] = static_cast<float>(std::max(0.0, mixes_[w].between([&](std::size_t i) { return place.radiance(skies_[i]); })));
    }

private:
    SkyBasis basis_;
    std::vector<double> bands_;
    std::vector<AxisPlace> mixes_;
    std::vector<BandSeries> skies_;  // a wavelength of the data
};

class Dobashi1997 : public PublishedSky {
public:
    Dobashi1997(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, Dobashi1997Data data, Reference air)
        : PublishedSky(card_of(data), atmosphere, std::move(wavelengths)), data_(std::move(data)), air_(std::move(air)) {
        for (const Wavelength w : this->wavelengths()) mixes_.push_back(place_on(data_.wavelengths_nm, w.in(nm)));
    }

    Result<std::vector<double>> transmittance(Length altitude, double view_zenith, Length distance) const override {
        if (const Result<Done> ok = within_range({altitude, view_zenith, 0.0, 0.0}); !ok) return ok.error();
        return air_.transmittance(altitude, view_zenith, distance);
    }

    Result<std::unique_ptr<SkyDome>> dome(Length altitude, double sun_zenith) const override {
        if (const Result<Done> ok = within_range({altitude, 0.0, sun_zenith, 0.0}); !ok) return ok.error();
        return std::unique_ptr<SkyDome>(std::make_unique<Dobashi1997Dome>(data_, mixes_, sun_zenith));
    }

private:
    // A series may fall below zero where the sky is dark; the sky does not.
    std::vector<double> sky_radiance(const View& view) const override {
        std::vector<double> radiance;
        for (const AxisPlace& mix : mixes_)
            radiance.push_back(std::max(0.0, mix.between([&](std::size_t w) { return data_.radiance(w, view); })));
        return radiance;
    }

    Dobashi1997Data data_;
    Reference air_;
    std::vector<AxisPlace> mixes_;
};

// The form that the user named; fails if he named another.
Result<std::optional<SkyBasis>> asked_basis(const ModelOptions& options) {
    if (options.variant.empty()) return std::optional<SkyBasis>();
    const Result<SkyBasis> basis = sky_basis_named(options.variant);
    if (!basis) return at(std::string(card.key), basis.error());
    return std::optional(*basis);
}

Result<Dobashi1997Data> of_file(const ModelOptions& options, std::optional<SkyBasis> basis, std::span<const Wavelength> wavelengths) {
    const Result<CoefficientText> text = coefficient_text(card.key, options.data, "a file of `airlight fit dobashi1997`");
    if (!text) return text.error();
    Result<Dobashi1997Data> data = parse_dobashi1997(text->text, text->where);
    if (!data) return data.error();
    if (basis && *basis != data->basis)
        return Error{text->where, fmt::format("holds {}, not {}", name_of(data->basis), options.variant), "Leave out the variant."};
    if (const Result<Done> ok = data_covers(data->wavelengths_nm, wavelengths, card.key); !ok) return ok.error();
    return data;
}

Result<Dobashi1997Data> of_single_scattering(const Atmosphere& atmosphere, SkyBasis basis, std::vector<Wavelength> wavelengths,
                                             const Progress& progress) {
    std::sort(wavelengths.begin(), wavelengths.end());
    wavelengths.erase(std::unique(wavelengths.begin(), wavelengths.end()), wavelengths.end());
    const Result<std::unique_ptr<Sky>> source = kaneda1991_model().make(atmosphere, std::move(wavelengths), {});
    if (!source) return source.error();
    return dobashi1997_series(**source, {.basis = basis}, progress);
}

Result<std::unique_ptr<Sky>> make(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions& options) {
    const Result<std::optional<SkyBasis>> basis = asked_basis(options);
    if (!basis) return basis.error();
    Result<Dobashi1997Data> data = options.data.empty()
                                       ? of_single_scattering(atmosphere, basis->value_or(SkyBasis::cosines), wavelengths, options.progress)
                                       : of_file(options, *basis, wavelengths);
    if (!data) return data.error();
    Result<Reference> air = Reference::of(atmosphere, wavelengths);
    if (!air) return air.error();
    return std::unique_ptr<Sky>(std::make_unique<Dobashi1997>(atmosphere, std::move(wavelengths), std::move(*data), std::move(*air)));
}

}  // namespace

Model dobashi1997_model() { return {card, make}; }

}  // namespace airlight
