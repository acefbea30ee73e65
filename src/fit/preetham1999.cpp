#include "fit/preetham1999.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "fit/colours.h"
#include "fit/preetham_form.h"
#include "fit/sun_views.h"

namespace airlight {

namespace {

using Numbers = std::vector<double>;
using Colours = std::array<Numbers, colour_quantities>;

constexpr double fitted_deg[] = {0.0, 15.0, 30.0, 45.0, 55.0, 65.0, 72.0, 78.0, 82.0, 85.0, 88.0, 90.0};
constexpr double between_deg[] = {22.0, 50.0, 68.0, 80.0, 84.0};
constexpr double weight_below = 0.3;  // of suns lower than are judged

std::vector<PreethamSky> skies_of(std::span<const SunViews> suns, std::span<const double> turbidities, std::span<const Colours> colours,
                                  std::size_t quantity) {
    std::vector<PreethamSky> skies;
    for (std::size_t t = 0; t < turbidities.size(); ++t)
        for (const SunViews& sun : suns) {
            skies.push_back({turbidities[t], sun.zenith_deg * deg, {}});
            for (std::size_t i = 0; i < sun.views.size(); ++i) {
                const SunView& v = sun.views[i];
                skies.back().samples.push_back(
                    {v.mu, v.nu, colours[t][quantity][sun.first + i], v.weight * (sun.judged() ? 1.0 : weight_below)});
            }
        }
    return skies;
}

RelativeRms residual(const Preetham1999Data& data, double turbidity, std::size_t quantity, std::span<const SunViews> suns,
                     const Numbers& truth) {
    return relative_rms(
        suns, [&](std::size_t i) { return truth[i]; },
        [&](const SunViews&, const SunView& v) {
            const f64::ColourYxy c = f64::preetham1999_sky(in_text(data, turbidity, v.view.sun_zenith), v.mu, v.nu);
            return (quantity == 0 ? f64::Number(std::max(0.0, c.luminance.value)) : (quantity == 1 ? c.x : c.y)).value;
        });
}

}  // namespace

Result<PreethamFit> fit_preetham1999(const Atmosphere& atmosphere, const PreethamFitSettings& s, Team& team, const JobStore& store,
                                     const Progress& progress) {
    std::vector<View> views;
    const std::vector<SunViews> suns = add_suns(fitted_deg, s.altitude, views), between = add_suns(between_deg, s.altitude, views);
    std::vector<TrueSky> skies;
    for (const double turbidity : s.turbidities) {
        Result<Atmosphere> air = with_turbidity(atmosphere, turbidity);
        if (!air) return air.error();
        skies.push_back({*std::move(air), views});
    }
    const WavelengthGrid grid = WavelengthGrid::standard();
    const std::vector<Wavelength> wavelengths(grid.begin(), grid.end());
    const Result<std::vector<Numbers>> truth = true_radiances(skies, wavelengths, s.truth, team, store, progress);
    if (!truth) return truth.error();
    const ColourWeights weights(grid, atmosphere.sun.irradiance);
    std::vector<Colours> colours;
    for (const Numbers& radiances : *truth) colours.push_back(colours_of(radiances, weights, wavelengths.size()));

    std::array<std::vector<TurbidityPolynomial>, colour_quantities> fitted;
    parallel_for(fitted.size(),
                 [&](std::size_t q) { fitted[q] = fitted_preetham(skies_of(suns, s.turbidities, colours, q), s.turbidities, q == 0); });
    PreethamFit fit{{s.turbidities.front(), s.turbidities.back(), s.altitude.in(m), {}}, {}};
    std::size_t row = 0;
    for (const auto& quantity : fitted)
        for (const TurbidityPolynomial& p : quantity) fit.data.coefficients[row++] = p;
    constexpr const char* names[] = {"luminance", "x", "y"};
    for (std::size_t t = 0; t < s.turbidities.size(); ++t)
        for (std::size_t q = 0; q < colour_quantities; ++q)
            for (const bool at_suns : {true, false})
                fit.residuals.push_back(
                    {fmt::format("{}, turbidity {:.3g}, {}", names[q], s.turbidities[t], at_suns ? "suns of the fit" : "suns between"),
                     residual(fit.data, s.turbidities[t], q, at_suns ? suns : between, colours[t][q]).value()});
    return fit;
}

}  // namespace airlight
