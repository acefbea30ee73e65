// hosek2012: an analytic model of the full spectral sky. [HosekWilkie2012; HosekWilkie2013]
//
//   computes     spectral radiance by nine parameters and a mean, each a Bezier curve of the fifth degree in
//                (elevation of the sun / 90 deg)^(1/3); bilinear in albedo and turbidity. Radiance is linear between the wavelengths
//                of the data, as in the published program; below zero, where data may fall at low suns, it is zero
//   leaves out   the eye's altitude, twilight, the kind of the aerosol, the sun's own spectrum (radiances are absolute, of the
//                data's sun). The published model of the sun's disk is not in the files: it is seen through the atmosphere's own air
//   parameters   data: the published set as a table, or a file of `airlight fit hosek` (hosek2012_data.h); turbidity (1 to 10 in
//                the published set), the atmosphere's own unless given; the ground's albedo, at each wavelength, from the
//                atmosphere; the sun 0 to 90 deg from the zenith; wavelengths of the data (320 to 720 nm in the published set).
//                A file may state another altitude than the ground's, and answers there alone.
//                A file of one turbidity or albedo is a fit to one atmosphere, and takes none from this one
//   cost         no precomputation; a formula with two exponentials and three roots a wavelength of the data
//   reference    the text is physics/models/hosek2012.glsl
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "models/axis.h"
#include "models/coefficient_table.h"
#include "models/direction_batch.h"
#include "models/hosek2012_data.h"
#include "models/list.h"
#include "models/turbidity.h"
#include "physics/models/f64.h"

namespace airlight {

namespace {

constexpr ModelCard card{.key = "hosek2012",
                         .paper = "HosekWilkie2012",
                         .scattering = "fitted to all orders",
                         .approach = "nine-parameter formula a wavelength, by turbidity and ground albedo",
                         .precomputation = "none",
                         .memory = "5 KiB a wavelength",
                         .highest_eye = 0.0 * m,
                         .highest_sun_zenith_deg = 90.0,
                         .highest_view_zenith_deg = 90.0};

// The data for one atmosphere: control points at the wavelengths that are used.
struct Bands {
    std::vector<Hosek2012Points> points;
    std::vector<AxisPlace> mixes;  // one a wavelength of the sky
};

// One reading's coefficients at a sun.
template <class Parameters, class Number>
Parameters parameters(const Hosek2012Points& points, double sun_zenith) {
    const f64::Number s = f64::hosek2012_place(sun_zenith);
    const auto at = [&](std::size_t c) -> Number {
        const auto& p = points[c];
        return f64::quintic_bezier(p[0], p[1], p[2], p[3], p[4], p[5], s).value;
    };
    return {at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7), at(8), at(9)};
}

class Hosek2012Dome : public SkyDome {
public:
    Hosek2012Dome(const Bands& bands, double sun_zenith) : mixes_(bands.mixes), sun_(sun_zenith) {
        for (const Hosek2012Points& points : bands.points)
            bands_.push_back(parameters<batch::Hosek2012, batch::Number>(points, sun_zenith));
    }

    void radiance(double view_zenith, double relative_azimuth, std::span<float> radiance) const override {
        const Direction direction{view_zenith, relative_azimuth};
        radiances({&direction, 1}, radiance);
    }

    void radiances(std::span<const Direction> directions, std::span<float> radiance) const override {
        std::vector<float> seen(bands_.size() * size);
        DirectionBatch d;
        for_each_batch(directions, [&](std::size_t first, std::span<const Direction> asked) {
            d.fill(asked, sun_);
            for (std::size_t b = 0; b < bands_.size(); ++b) band(bands_[b], d, {&seen[b * size], asked.size()});
            store(seen, asked, &radiance[first * mixes_.size()]);
        });
    }

private:
    static constexpr std::size_t size = DirectionBatch::size;

    // The loop that counts: over directions, all of one band.
    static void band(const batch::Hosek2012& at, const DirectionBatch& d, std::span<float> seen) {
        using batch::Number;
        const batch::Hosek2012 k = at;
        for (std::size_t i = 0; i < seen.size(); ++i)
            seen[i] = batch::hosek2012_radiance(k, Number::of(d.mu[i]), Number::of(d.nu[i]), Number::of(d.gamma[i])).value;
    }

    void store(const std::vector<float>& seen, std::span<const Direction> asked, float* out) const {
        const std::size_t n = mixes_.size();
        for (std::size_t w = 0; w < n; ++w) {
            const float *low = &seen[mixes_[w].low * size], *high = &seen[mixes_[w].high * size];
            const float weight = static_cast<float>(mixes_[w].weight);
            for (std::size_t i = 0; i < asked.size(); ++i) {
                const float value = low[i] + weight * (high[i] - low[i]);
                out[i * n + w] = value > 0.0f ? value : 0.0f;
            }
        }
        for (std::size_t i = 0; i < asked.size(); ++i)
            if (below_horizon(asked[i])) std::fill_n(out + i * n, n, 0.0f);
    }

    std::vector<AxisPlace> mixes_;
    BatchSun sun_;
    std::vector<batch::Hosek2012> bands_;
};

class Hosek2012Sky : public PublishedSky {
public:
    Hosek2012Sky(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, Length altitude, Bands bands, Reference air)
        : PublishedSky(card_at(altitude), atmosphere, std::move(wavelengths)), bands_(std::move(bands)), air_(std::move(air)) {}

    Result<std::vector<double>> transmittance(Length altitude, double view_zenith, Length distance) const override {
        if (const Result<Done> ok = within_range({altitude, view_zenith, 0.0, 0.0}); !ok) return ok.error();
        return air_.transmittance(altitude, view_zenith, distance);
    }

    Result<std::unique_ptr<SkyDome>> dome(Length altitude, double sun_zenith) const override {
        if (const Result<Done> ok = within_range({altitude, 0.0, sun_zenith, 0.0}); !ok) return ok.error();
        return std::unique_ptr<SkyDome>(std::make_unique<Hosek2012Dome>(bands_, sun_zenith));
    }

private:
    static ModelCard card_at(Length altitude) {
        ModelCard c = card;
        c.lowest_eye = c.highest_eye = altitude;
        return c;
    }

    std::vector<double> sky_radiance(const View& view) const override {
        const f64::Number mu = std::max(0.0, std::cos(view.view_zenith)), nu = view_sun_cosine(view);
        const f64::Number gamma = f64::angle_of_cosine(nu);
        std::vector<double> seen, radiance;
        for (const Hosek2012Points& points : bands_.points)
            seen.push_back(f64::hosek2012_radiance(parameters<f64::Hosek2012, f64::Number>(points, view.sun_zenith), mu, nu, gamma).value);
        for (const AxisPlace& mix : bands_.mixes) radiance.push_back(std::max(0.0, std::lerp(seen[mix.low], seen[mix.high], mix.weight)));
        return radiance;
    }

    Bands bands_;
    Reference air_;
};

// Keeps what lies next to a wavelength of the sky.
Bands bands_of(const Hosek2012Data& data, const Atmosphere& atmosphere, std::span<const Wavelength> wavelengths, double turbidity) {
    Bands bands;
    std::vector<std::size_t> kept;
    const auto band = [&](std::size_t w) {
        const auto found = std::find(kept.begin(), kept.end(), w);
        if (found != kept.end()) return static_cast<std::size_t>(found - kept.begin());
        const double albedo = atmosphere.ground_albedo.at(data.wavelengths_nm[w] * nm).value;
        bands.points.push_back(data.between(w, albedo, turbidity));
        kept.push_back(w);
        return kept.size() - 1;
    };
    for (const Wavelength wavelength : wavelengths) {
        const AxisPlace mix = place_on(data.wavelengths_nm, wavelength.in(nm));
        const std::size_t low = band(mix.low);
        bands.mixes.push_back({low, band(mix.high), mix.weight});
    }
    return bands;
}

// The ground's albedo must lie within the data's, unless the data has but one.
Result<Done> albedo_in(const Hosek2012Data& data, const Atmosphere& atmosphere) {
    if (data.albedos.size() == 1) return Done{};
    for (const double w : data.wavelengths_nm) {
        const double albedo = atmosphere.ground_albedo.at(w * nm).value;
        if (albedo < data.albedos.front() || albedo > data.albedos.back())
            return Error{
                std::string(card.key),
                fmt::format("does not answer a ground albedo of {:.3g}, which is that of {} at {:g} nm: its data is for {:g} to {:g}",
                            albedo, atmosphere.name, w, data.albedos.front(), data.albedos.back()),
                ""};
    }
    return Done{};
}

Result<std::unique_ptr<Sky>> make(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions& options) {
    const Result<CoefficientText> text =
        coefficient_text(card.key, options.data, "the published set as a table, or a file of `airlight fit hosek`,");
    if (!text) return text.error();
    const Result<Hosek2012Data> data = parse_hosek2012(text->text, text->where);
    if (!data) return data.error();
    if (const Result<Done> ok = data_covers(data->wavelengths_nm, wavelengths, card.key); !ok) return ok.error();
    if (const Result<Done> ok = albedo_in(*data, atmosphere); !ok) return ok.error();
    double t = data->turbidities.front();
    if (data->turbidities.size() > 1) {
        const Result<double> asked = turbidity_in(data->turbidities.front(), data->turbidities.back(), card.key, atmosphere, options);
        if (!asked) return asked.error();
        t = *asked;
    }
    Result<Reference> air = Reference::of(atmosphere, wavelengths);
    if (!air) return air.error();
    Bands bands = bands_of(*data, atmosphere, wavelengths, t);
    return std::unique_ptr<Sky>(
        std::make_unique<Hosek2012Sky>(atmosphere, std::move(wavelengths), data->altitude_m * m, std::move(bands), std::move(*air)));
}

}  // namespace

Model hosek2012_model() { return {card, make}; }

}  // namespace airlight
