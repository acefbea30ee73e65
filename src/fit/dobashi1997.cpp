#include "fit/dobashi1997.h"

#include <algorithm>

#include "fit/sun_views.h"

namespace airlight {

namespace {

using Numbers = std::vector<double>;

// Of the 21 suns of the series, and halfway between two.
constexpr double at_suns_deg[] = {5.0, 30.0, 60.0, 80.0, 83.0}, between_suns_deg[] = {17.5, 42.5, 67.5, 77.5, 81.5};

double residual(const Dobashi1997Data& data, std::span<const SunViews> suns, const Numbers& truth) {
    RelativeRms rms;
    const std::size_t n = data.wavelengths_nm.size();
    for (std::size_t w = 0; w < n; ++w)
        rms.add(relative_rms(
            suns, [&](std::size_t i) { return truth[i * n + w]; },
            [&](const SunViews&, const SunView& v) { return std::max(0.0, data.radiance(w, v.view)); }));
    return rms.value();
}

}  // namespace

Result<DobashiFit> fit_dobashi1997(const Atmosphere& atmosphere, std::span<const Wavelength> wavelengths,
                                   const Dobashi1997Settings& settings, const TruthSettings& truth_settings, Team& team,
                                   const JobStore& store, const Progress& progress) {
    TrueSky sky{atmosphere, dobashi1997_views(settings)};
    const std::size_t sampled = sky.views.size() * wavelengths.size();
    const std::vector<SunViews> at = add_suns(at_suns_deg, settings.altitude, sky.views),
                                between = add_suns(between_suns_deg, settings.altitude, sky.views);
    const Result<std::vector<Numbers>> truth = true_radiances({&sky, 1}, wavelengths, truth_settings, team, store, progress);
    if (!truth) return truth.error();
    DobashiFit fit{dobashi1997_series(std::span(truth->front()).first(sampled), wavelengths, settings), {}};
    fit.residuals = {{"suns of the series", residual(fit.data, at, truth->front())},
                     {"suns between", residual(fit.data, between, truth->front())}};
    return fit;
}

}  // namespace airlight
