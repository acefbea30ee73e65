#include "fit/sun_views.h"

#include <algorithm>
#include <cmath>

namespace airlight {

std::vector<SunViews> add_suns(std::span<const double> zeniths_deg, Length altitude, std::vector<View>& views) {
    std::vector<SunViews> suns;
    for (const double zenith : zeniths_deg) {
        suns.push_back({zenith, views.size(), {}});
        for (const FitDirection& d : fit_directions(zenith * deg, 12, 12)) {
            const View view{altitude, d.direction.view_zenith, zenith * deg, d.direction.relative_azimuth};
            suns.back().views.push_back({view, d.weight, std::cos(view.view_zenith), std::clamp(view_sun_cosine(view), -1.0, 1.0)});
            views.push_back(view);
        }
    }
    return suns;
}

RelativeRms relative_rms(std::span<const SunViews> suns, const std::function<double(std::size_t)>& truth,
                         const std::function<double(const SunViews&, const SunView&)>& model) {
    RelativeRms rms;
    for (const SunViews& sun : suns) {
        if (!sun.judged()) continue;
        for (std::size_t i = 0; i < sun.views.size(); ++i)
            if (sun.views[i].weight == 1.0) rms.add(model(sun, sun.views[i]), truth(sun.first + i));
    }
    return rms;
}

}  // namespace airlight
