#include "fit/hosek2012.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "core/parallel.h"
#include "fit/rounded.h"

namespace airlight {

namespace {

using Numbers = std::vector<double>;

constexpr std::string_view version = "hosek2012 fit 8";

// Elevations of the sun that are fitted, dense where the sky changes fastest, and others between them that judge the fit.
constexpr double fitted_deg[] = {0.0, 1.0, 2.5, 5.0, 8.0, 12.0, 18.0, 26.0, 38.0, 52.0, 70.0, 90.0};
constexpr double judged_deg[] = {6.5, 10.0, 15.0, 22.0, 32.0, 45.0, 60.0, 80.0};
constexpr double lowest_judged_deg = 5.0;
constexpr double weight_below = 0.3;  // of suns lower than that

struct FitView {
    View view;
    double weight;
    bool fitted;
    bool judged;
};

std::vector<FitView> fit_views(Length altitude) {
    std::vector<FitView> views;
    const auto add = [&](double elevation_deg, bool fitted, int rings, int azimuths) {
        const double sun = (90.0 - elevation_deg) * deg;
        const double weight = elevation_deg < lowest_judged_deg ? weight_below : 1.0;
        for (const FitDirection& d : fit_directions(sun, rings, azimuths))
            views.push_back({{altitude, d.direction.view_zenith, sun, d.direction.relative_azimuth},
                             weight * d.weight,
                             fitted,
                             d.weight == 1.0 && elevation_deg >= lowest_judged_deg});
    };
    for (const double elevation : fitted_deg) add(elevation, true, 12, 12);
    for (const double elevation : judged_deg) add(elevation, false, 9, 10);
    return views;
}

// Skies in the order [albedo][turbidity].
Result<std::vector<TrueSky>> skies_of(const Atmosphere& atmosphere, const HosekFitSettings& s, std::span<const FitView> views) {
    std::vector<TrueSky> skies;
    for (const double albedo : s.albedos)
        for (const double turbidity : s.turbidities) {
            Result<Atmosphere> air = with_turbidity(atmosphere, turbidity);
            if (!air) return air.error();
            air->ground_albedo = SpectrumOf<Number>::constant(albedo);
            skies.push_back({*std::move(air), {}});
            for (const FitView& v : views) skies.back().views.push_back(v.view);
        }
    return skies;
}

std::vector<HosekSample> samples_of(std::span<const FitView> views, const Numbers& radiances, std::size_t wavelength, std::size_t count) {
    std::vector<HosekSample> samples;
    for (std::size_t i = 0; i < views.size(); ++i) {
        const double truth = radiances[i * count + wavelength];
        if (!views[i].fitted || !(truth > 0.0)) continue;
        const View& v = views[i].view;
        samples.push_back(
            {v.sun_zenith, std::cos(v.view_zenith), std::acos(std::clamp(view_sun_cosine(v), -1.0, 1.0)), truth, views[i].weight});
    }
    return samples;
}

// The order in which turbidities are fitted, each with a neighbour before it: up from the one nearest to 2, then down. So air without
// aerosol, whose sky says nothing of an aureole, keeps the aureole's shape of the air with some.
std::vector<std::size_t> order_of(std::span<const double> turbidities) {
    std::size_t middle = 0;
    for (std::size_t i = 0; i < turbidities.size(); ++i)
        if (std::abs(turbidities[i] - 2.0) < std::abs(turbidities[middle] - 2.0)) middle = i;
    std::vector<std::size_t> order;
    for (std::size_t i = middle; i < turbidities.size(); ++i) order.push_back(i);
    for (std::size_t i = middle; i-- > 0;) order.push_back(i);
    return order;
}

// All curves of one wavelength: [albedo][turbidity], each begun where a neighbour ended.
Numbers curves_of(const HosekFitSettings& s, std::span<const FitView> views, const std::vector<Numbers>& truth, std::size_t wavelength) {
    const std::vector<std::size_t> order = order_of(s.turbidities);
    const std::size_t turbidities = s.turbidities.size();
    std::vector<HosekCurves> curves(truth.size());
    for (std::size_t a = 0; a < s.albedos.size(); ++a)
        for (const std::size_t t : order) {
            const std::size_t i = a * turbidities + t;
            const HosekCurves* similar = a > 0               ? &curves[i - turbidities]
                                         : t > order.front() ? &curves[i - 1]
                                         : t < order.front() ? &curves[i + 1]
                                                             : nullptr;
            curves[i] = fitted_hosek(samples_of(views, truth[i], wavelength, s.wavelengths.size()), similar);
        }
    Numbers numbers;
    for (const HosekCurves& points : curves)
        for (const auto& coefficient : points)
            for (const double p : coefficient) numbers.push_back(rounded(p, 7));  // as float has them: a third of the text
    return numbers;
}

std::vector<Job> fit_jobs(const HosekFitSettings& s, std::span<const FitView> views, const std::vector<Numbers>& truth) {
    JobKey all(version);
    for (const Numbers& numbers : truth) all.add(numbers);
    std::vector<Job> jobs;
    for (std::size_t w = 0; w < s.wavelengths.size(); ++w) {
        JobKey key = all;
        key.add(Numbers{static_cast<double>(w)});
        jobs.push_back(
            {key.hash(), [&s, views, &truth, w](const Progress&) { return Result<Numbers>(curves_of(s, views, truth, w)); }, true});
    }
    return jobs;
}

// At every judged view, whatever the wavelength and the albedo.
Residuals residuals_of(const Hosek2012Data& data, std::span<const FitView> views, const std::vector<Numbers>& truth) {
    Residuals residuals;
    const std::size_t wavelengths = data.wavelengths_nm.size(), turbidities = data.turbidities.size();
    for (std::size_t t = 0; t < turbidities; ++t) {
        RelativeRms fitted, between;
        for (std::size_t a = 0; a < data.albedos.size(); ++a)
            for (std::size_t w = 0; w < wavelengths; ++w)
                for (std::size_t i = 0; i < views.size(); ++i) {
                    if (!views[i].judged) continue;
                    const View& v = views[i].view;
                    const double model = hosek_radiance(data.points[data.index(w, a, t)], v.sun_zenith, std::cos(v.view_zenith),
                                                        std::acos(std::clamp(view_sun_cosine(v), -1.0, 1.0)));
                    (views[i].fitted ? fitted : between).add(model, truth[a * turbidities + t][i * wavelengths + w]);
                }
        residuals.push_back({fmt::format("turbidity {:.3g}, suns of the fit", data.turbidities[t]), fitted.value()});
        residuals.push_back({fmt::format("turbidity {:.3g}, suns between", data.turbidities[t]), between.value()});
    }
    return residuals;
}

}  // namespace

Result<HosekFit> fit_hosek2012(const Atmosphere& atmosphere, const HosekFitSettings& settings, Team& team, const JobStore& store,
                               const Progress& progress) {
    const std::vector<FitView> views = fit_views(settings.altitude);
    const Result<std::vector<TrueSky>> skies = skies_of(atmosphere, settings, views);
    if (!skies) return skies.error();
    const Result<std::vector<Numbers>> truth = true_radiances(*skies, settings.wavelengths, settings.truth, team, store, progress);
    if (!truth) return truth.error();
    const Result<std::vector<Numbers>> fitted = team.computed(fit_jobs(settings, views, *truth), store, "fit", progress);
    if (!fitted) return fitted.error();
    HosekFit fit{{{}, settings.albedos, settings.turbidities, {}, settings.altitude.in(m)}, {}};
    for (const Wavelength w : settings.wavelengths) fit.data.wavelengths_nm.push_back(w.in(nm));
    for (const Numbers& numbers : *fitted) {
        std::vector<HosekCurves> curves(truth->size());
        if (numbers.size() * sizeof(double) != curves.size() * sizeof(HosekCurves))
            return Error{"", "a finished job has the wrong size", "Choose another --cache."};
        std::memcpy(curves.data(), numbers.data(), numbers.size() * sizeof(double));
        fit.data.points.insert(fit.data.points.end(), curves.begin(), curves.end());
    }
    fit.residuals = residuals_of(fit.data, views, *truth);
    return fit;
}

std::string hosek_csv(const HosekFit& fit, std::string_view atmosphere) {
    return hosek2012_csv(
        fit.data,
        fmt::format("# hosek2012 fitted by `airlight fit` to {}, eye at {:g} m: control points of quintic Bezier curves in (elevation / 90 "
                    "deg)^(1/3)\n"
                    "# radiance = mean (1 + A exp(B / (cos theta + 0.01))) (C + D exp(E gamma) + F cos^2 gamma + G (1 + cos^2 gamma) / "
                    "(1 + I^2 - 2 I cos gamma)^1.5 + H sqrt(cos theta)), mean = the row radiance, W m-2 sr-1 nm-1; bilinear in albedo and "
                    "turbidity",
                    atmosphere, fit.data.altitude_m));
}

}  // namespace airlight
