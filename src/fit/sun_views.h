// The views that a fit of one formula a sun asks for: directions around an eye, sun after sun.
// Uses the truth (truth.h) and residuals.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "fit/residual.h"
#include "fit/truth.h"

namespace airlight {

// Suns below count less in fits, and do not count in residuals: light fades there faster than any of the formulas.
inline constexpr double lowest_judged_sun_deg = 85.0;

struct SunView {
    View view;
    double weight;  // of FitDirection
    double mu, nu;  // cosines of the view's zenith angle and of the angle from the sun
};

// The views of one sun, and where they begin among all.
struct SunViews {
    double zenith_deg;
    std::size_t first;
    std::vector<SunView> views;

    bool judged() const { return zenith_deg <= lowest_judged_sun_deg; }
};

// Adds the views of suns, 12 x 12 directions each and some more (fit_directions()), to `views`.
std::vector<SunViews> add_suns(std::span<const double> zeniths_deg, Length altitude, std::vector<View>& views);

// How far a model is from the truth in all judged views of equal solid angle.
//   truth, model  of the view first + i, and of the i-th of a sun
RelativeRms relative_rms(std::span<const SunViews> suns, const std::function<double(std::size_t)>& truth,
                         const std::function<double(const SunViews&, const SunView&)>& model);

}  // namespace airlight
