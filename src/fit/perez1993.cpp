#include "fit/perez1993.h"

#include "core/parallel.h"
#include "fit/perez_form.h"
#include "fit/sun_views.h"

namespace airlight {

namespace {

using Numbers = std::vector<double>;

constexpr double fitted_deg[] = {0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 68.0, 74.0, 79.0, 83.0, 86.0, 88.0, 90.0};
constexpr double between_deg[] = {15.0, 35.0, 55.0, 71.0, 81.0, 84.5};

// All suns at one wavelength of n.
std::vector<PerezForm> forms_of(std::span<const SunViews> suns, const Numbers& truth, std::size_t w, std::size_t n) {
    std::vector<std::vector<PerezSample>> samples(suns.size());
    for (std::size_t s = 0; s < suns.size(); ++s)
        for (std::size_t i = 0; i < suns[s].views.size(); ++i) {
            const SunView& v = suns[s].views[i];
            samples[s].push_back({v.mu, v.nu, truth[(suns[s].first + i) * n + w], v.weight});
        }
    return fitted_perez(samples);
}

double residual(const Perez1993Data& data, std::span<const SunViews> suns, const Numbers& truth) {
    RelativeRms rms;
    const std::size_t n = data.wavelengths_nm.size();
    for (std::size_t w = 0; w < n; ++w)
        rms.add(relative_rms(
            suns, [&](std::size_t i) { return truth[i * n + w]; },
            [&](const SunViews&, const SunView& v) { return data.radiance(w, v.view); }));
    return rms.value();
}

}  // namespace

Result<PerezFit> fit_perez1993(const Atmosphere& atmosphere, std::span<const Wavelength> wavelengths, Length altitude,
                               const TruthSettings& settings, Team& team, const JobStore& store, const Progress& progress) {
    TrueSky sky{atmosphere, {}};
    const std::vector<SunViews> suns = add_suns(fitted_deg, altitude, sky.views), between = add_suns(between_deg, altitude, sky.views);
    const Result<std::vector<Numbers>> truth = true_radiances({&sky, 1}, wavelengths, settings, team, store, progress);
    if (!truth) return truth.error();
    std::vector<std::vector<PerezForm>> forms(wavelengths.size());
    parallel_for(forms.size(), [&](std::size_t w) { forms[w] = forms_of(suns, truth->front(), w, forms.size()); });
    PerezFit fit{{altitude.in(m), {}, {std::begin(fitted_deg), std::end(fitted_deg)}, {}}, {}};
    for (std::size_t w = 0; w < forms.size(); ++w) {
        fit.data.wavelengths_nm.push_back(wavelengths[w].in(nm));
        fit.data.forms.insert(fit.data.forms.end(), forms[w].begin(), forms[w].end());
    }
    fit.residuals = {{"suns of the fit", residual(fit.data, suns, truth->front())},
                     {"suns between", residual(fit.data, between, truth->front())}};
    return fit;
}

}  // namespace airlight
