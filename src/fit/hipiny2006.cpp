#include "fit/hipiny2006.h"

#include <fmt/format.h>

#include <cmath>

#include "core/parallel.h"
#include "fit/colours.h"
#include "fit/perez_form.h"
#include "fit/rounded.h"
#include "fit/sun_views.h"

namespace airlight {

namespace {

using Numbers = std::vector<double>;

constexpr double fitted_deg[] = {0.0, 15.0, 30.0, 45.0, 60.0, 70.0, 78.0, 84.0, 88.0, 90.0};
constexpr double between_deg[] = {22.0, 52.0, 74.0, 81.0};
constexpr int digits = 6;

// One sky of tables and what is asked of it: [altitude] suns of the fit, and between them.
struct Asked {
    std::vector<View> views;
    std::vector<std::vector<SunViews>> fitted, between;
};

Asked asked_at(std::span<const double> altitudes_m) {
    Asked asked;
    for (const double altitude : altitudes_m) {
        asked.fitted.push_back(add_suns(fitted_deg, altitude * m, asked.views));
        asked.between.push_back(add_suns(between_deg, altitude * m, asked.views));
    }
    return asked;
}

std::vector<PerezForm> forms_of(std::span<const SunViews> suns, const Numbers& truth) {
    std::vector<std::vector<PerezSample>> samples(suns.size());
    for (std::size_t s = 0; s < suns.size(); ++s)
        for (std::size_t i = 0; i < suns[s].views.size(); ++i) {
            const SunView& v = suns[s].views[i];
            samples[s].push_back({v.mu, v.nu, truth[suns[s].first + i], v.weight});
        }
    return fitted_perez(samples);
}

// The formula's scale as its value straight up.
Hipiny2006Fit in_file(const PerezForm& form, double sun_zenith) {
    const auto r = [](double x) { return rounded(x, digits); };
    return {r(form.k.a.value), r(form.k.b.value), r(form.k.c.value),
            r(form.k.d.value), r(form.k.e.value), r(form.value(1.0, std::cos(sun_zenith)))};
}

// The patches of one altitude and turbidity, sun after sun.
std::vector<Hipiny2006Patch> patches_of(std::span<const SunViews> suns, const std::array<Numbers, colour_quantities>& truth) {
    std::array<std::vector<PerezForm>, colour_quantities> forms;
    for (std::size_t q = 0; q < forms.size(); ++q) forms[q] = forms_of(suns, truth[q]);
    std::vector<Hipiny2006Patch> patches;
    for (std::size_t s = 0; s < suns.size(); ++s) {
        const double sun = suns[s].zenith_deg * deg;
        patches.push_back({in_file(forms[0][s], sun), in_file(forms[1][s], sun), in_file(forms[2][s], sun)});
    }
    return patches;
}

// Of one altitude, all turbidities: [quantity].
using Rms = std::array<RelativeRms, colour_quantities>;

void add_residuals(Rms& rms, const Hipiny2006Data& data, std::size_t altitude, std::size_t turbidity, std::span<const SunViews> suns,
                   const std::array<Numbers, colour_quantities>& truth) {
    for (std::size_t q = 0; q < rms.size(); ++q)
        rms[q].add(relative_rms(
            suns, [&](std::size_t i) { return truth[q][i]; },
            [&](const SunViews&, const SunView& v) {
                const f64::ColourYxy c = hipiny2006_colour(data, altitude, turbidity, v.view.sun_zenith, v.mu, v.nu);
                return (q == 0 ? c.luminance : (q == 1 ? c.x : c.y)).value;
            }));
}

void add_lines(Residuals& lines, const Rms& rms, double altitude_m, const char* suns) {
    constexpr const char* names[] = {"luminance", "x", "y"};
    for (std::size_t q = 0; q < rms.size(); ++q)
        lines.push_back({fmt::format("{}, eye at {:g} m, {}", names[q], altitude_m, suns), rms[q].value()});
}

Result<std::vector<TrueSky>> skies_of(const Atmosphere& atmosphere, std::span<const double> turbidities, const std::vector<View>& views) {
    std::vector<TrueSky> skies;
    for (const double turbidity : turbidities) {
        Result<Atmosphere> air = with_turbidity(atmosphere, turbidity);
        if (!air) return air.error();
        skies.push_back({*std::move(air), views});
    }
    return skies;
}

}  // namespace

Result<HipinyFit> fit_hipiny2006(const Atmosphere& atmosphere, const HipinyFitSettings& s, Team& team, const JobStore& store,
                                 const Progress& progress) {
    const Asked asked = asked_at(s.altitudes_m);
    const Result<std::vector<TrueSky>> skies = skies_of(atmosphere, s.turbidities, asked.views);
    if (!skies) return skies.error();
    const WavelengthGrid grid = WavelengthGrid::standard();
    const std::vector<Wavelength> wavelengths(grid.begin(), grid.end());
    const Result<std::vector<Numbers>> truth = true_radiances(*skies, wavelengths, s.truth, team, store, progress);
    if (!truth) return truth.error();
    const ColourWeights weights(grid, atmosphere.sun.irradiance);
    std::vector<std::array<Numbers, colour_quantities>> colours;
    for (const Numbers& radiances : *truth) colours.push_back(colours_of(radiances, weights, wavelengths.size()));

    const std::size_t altitudes = s.altitudes_m.size(), turbidities = s.turbidities.size();
    std::vector<std::vector<Hipiny2006Patch>> patches(altitudes * turbidities);
    parallel_for(patches.size(), [&](std::size_t i) { patches[i] = patches_of(asked.fitted[i / turbidities], colours[i % turbidities]); });
    HipinyFit fit{{s.altitudes_m, s.turbidities, {std::begin(fitted_deg), std::end(fitted_deg)}, {}}, {}};
    for (const auto& sky : patches) fit.data.patches.insert(fit.data.patches.end(), sky.begin(), sky.end());
    for (std::size_t a = 0; a < altitudes; ++a) {
        Rms fitted, between;
        for (std::size_t t = 0; t < turbidities; ++t) {
            add_residuals(fitted, fit.data, a, t, asked.fitted[a], colours[t]);
            add_residuals(between, fit.data, a, t, asked.between[a], colours[t]);
        }
        add_lines(fit.residuals, fitted, s.altitudes_m[a], "suns of the fit");
        add_lines(fit.residuals, between, s.altitudes_m[a], "suns between");
    }
    return fit;
}

}  // namespace airlight
