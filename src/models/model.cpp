#include "models/model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "atmosphere/validate.h"
#include "core/quadrature.h"
#include "models/list.h"

namespace airlight {

std::span<const Model> models() {
    // One a line.
    // clang-format off
    static const Model all[] = {
        reference_model(),
        tables_model(),
        fog_model(),
        klassen1987_model(),
        kaneda1991_model(),
        nishita1993_model(),
        perez1993_model(),
        nishita1996_model(),
        dobashi1997_model(),
        preetham1999_model(),
        dobashi2002_model(),
        hoffman2002_model(),
        cie2003_model(),
        nielsen2003_model(),
        oneil2004_model(),
        oneil2005_model(),
        hipiny2006_model(),
        schafhitzel2007_model(),
        bruneton2008_model(),
        elek2009_model(),
        hosek2012_model(),
        hillaire2020_model(),
        prague2021_model(),
        airlight_model(),
    };
    // clang-format on
    return all;
}

const Model* find_model(std::string_view key) {
    const auto all = models();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Model& model) { return model.card.key == key; });
    return found == all.end() ? nullptr : &*found;
}

Result<std::unique_ptr<Sky>> make_sky(std::string_view key, const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths,
                                      const ModelOptions& options) {
    const Model* model = find_model(key);
    if (!model) {
        std::string keys;
        for (const Model& known : models()) keys.append(keys.empty() ? "" : " ").append(known.card.key);
        const std::string near = nearest_word(key, keys);
        return Error{"", fmt::format("\"{}\" is no model", key),
                     near.empty() ? fmt::format("Models are: {}.", keys) : fmt::format("Did you mean {}?", near)};
    }
    if (wavelengths.empty()) return Error{"wavelengths", "there is none", "Give at least one."};
    const auto [first, last] = std::minmax_element(wavelengths.begin(), wavelengths.end());
    if (const Result<Done> covered = covers(atmosphere, *first, *last); !covered) return covered.error();
    return model->make(atmosphere, std::move(wavelengths), options);
}

PublishedSky::PublishedSky(const ModelCard& card, const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths)
    : card_(card), atmosphere_(atmosphere), wavelengths_(std::move(wavelengths)) {
    for (const Wavelength w : wavelengths_) solar_irradiance_.push_back(atmosphere_.sun.irradiance.at(w).in(W_per_m2_nm));
}

Result<Done> PublishedSky::within_range(const View& view) const {
    if (const Result<Done> ok = check_view(view.altitude, view.view_zenith, view.sun_zenith, view.relative_azimuth); !ok) return ok.error();
    const auto outside = [&](const char* what, double value, double highest, const char* unit, double lowest = 0.0) {
        return Error{name(),
                     fmt::format("does not answer {} {:g} {}: its range is {:g} to {:g} {}", what, value, unit, lowest, highest, unit),
                     "`airlight models` shows the range of each model."};
    };
    constexpr double hair = 1e-9;
    if (view.altitude < card_.lowest_eye || view.altitude > card_.highest_eye)
        return outside("an eye at", view.altitude.in(m), card_.highest_eye.in(m), "m", card_.lowest_eye.in(m));
    if (view.sun_zenith / deg > card_.highest_sun_zenith_deg + hair)
        return outside("a sun zenith angle of", view.sun_zenith / deg, card_.highest_sun_zenith_deg, "deg");
    if (view.view_zenith / deg > card_.highest_view_zenith_deg + hair)
        return outside("a view zenith angle of", view.view_zenith / deg, card_.highest_view_zenith_deg, "deg");
    return Done{};
}

Result<Done> PublishedSky::answerable(const View&) const { return Done{}; }

Result<RadianceEstimate> PublishedSky::radiance(const View& view) const {
    if (const Result<Done> ok = within_range(view); !ok) return ok.error();
    if (const Result<Done> ok = answerable(view); !ok) return ok.error();
    RadianceEstimate estimate{sky_radiance(view), std::vector<double>(wavelengths_.size(), 0.0)};
    return estimate;
}

Result<IrradianceEstimate> PublishedSky::irradiance(Length altitude, double sun_zenith) const {
    if (const Result<Done> ok = within_range({altitude, 0.0, sun_zenith, 0.0}); !ok) return ok.error();
    IrradianceEstimate estimate;
    estimate.direct_W_m2_nm.assign(wavelengths_.size(), 0.0);
    estimate.diffuse_W_m2_nm.assign(wavelengths_.size(), 0.0);
    estimate.standard_error.assign(wavelengths_.size(), 0.0);
    // Gauss's rule in the square of the cosine, which the weight of a level surface makes even; midpoints over half a turn.
    constexpr int azimuths = 32;
    const GaussRule rule = gauss_rule(32, 0.0, 1.0);
    for (std::size_t i = 0; i < rule.nodes.size(); ++i)
        for (int j = 0; j < azimuths; ++j) {
            const View view{altitude, std::acos(std::sqrt(rule.nodes[i])), sun_zenith, (j + 0.5) * pi / azimuths};
            if (const Result<Done> ok = answerable(view); !ok) return ok.error();
            const std::vector<double> seen = sky_radiance(view);
            for (std::size_t w = 0; w < seen.size(); ++w) estimate.diffuse_W_m2_nm[w] += seen[w] * rule.weights[i] * pi / azimuths;
        }
    if (sun_zenith >= 0.5 * pi) return estimate;
    const Result<std::vector<double>> beam = transmittance(altitude, sun_zenith, 1e12 * m);
    if (!beam) return beam.error();
    for (std::size_t w = 0; w < wavelengths_.size(); ++w)
        estimate.direct_W_m2_nm[w] = (*beam)[w] * solar_irradiance_[w] * std::cos(sun_zenith);
    return estimate;
}

Result<std::vector<double>> PublishedSky::transmittance(Length, double, Length) const {
    return Error{name(), "has no transmittance", "`airlight models` shows what each model answers."};
}

}  // namespace airlight
