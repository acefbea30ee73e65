#include "eval/aerial.h"

#include <algorithm>
#include <cmath>

#include "physics/f64.h"

namespace airlight {

namespace {

constexpr double end_of_plain_day_deg = 80.0;  // where the reference needs no more than its plain number of paths

struct Look {
    double below_horizontal_deg, azimuth_deg;
};
constexpr Look looks[] = {{-1.0, 30.0}, {-1.0, 150.0}, {4.0, 90.0}};

// How far one sees before the ground or the end of the air.
double way_m(const Atmosphere& atmosphere, const View& view) {
    const auto metres = [](double x) { return f64::Length::of(x); };
    const f64::Length h = metres(view.altitude.in(m)), bottom = metres(atmosphere.bottom_radius.in(m)),
                      top = metres(atmosphere.top_altitude.in(m));
    const double mu = std::cos(view.view_zenith);
    return (f64::meets_ground(h, mu, bottom) ? f64::distance_to_ground(h, mu, bottom) : f64::distance_to_top(h, mu, bottom, top)).value;
}

struct Sums {
    int values = 0;
    double square = 0.0, variance = 0.0, transmittance = 0.0;

    void add(const AerialTruth& truth, const AerialPerspective& found) {
        for (std::size_t w = 0; w < truth.transmittance.size(); ++w) {
            const double light = truth.inscattered.radiance_W_m2_sr_nm[w];
            ++values;
            square += std::pow(found.inscattered_W_m2_sr_nm[w] / light - 1.0, 2.0);
            variance += std::pow(truth.inscattered.standard_error[w] / light, 2.0);
            transmittance += std::pow(found.transmittance[w] - truth.transmittance[w], 2.0);
        }
    }
};

}  // namespace

bool aerial_judged(const Atmosphere& atmosphere, const Condition& condition) {
    return condition.sun_zenith_deg <= end_of_plain_day_deg && condition.altitude < atmosphere.top_altitude;
}

Result<std::vector<AerialTruth>> aerial_truths(const Reference& reference, const Atmosphere& atmosphere, const Condition& condition,
                                               const ReferenceSettings& settings, const Progress& progress) {
    std::vector<AerialTruth> truths;
    for (const Look& look : looks)
        for (std::size_t d = 0; d < aerial_distances_m.size(); ++d) {
            const View view = view_of(condition, {(90.0 + look.below_horizontal_deg) * deg, look.azimuth_deg * deg});
            const Length distance = aerial_distances_m[d] * m;
            if (distance.value >= way_m(atmosphere, view)) continue;
            Result<RadianceEstimate> light = reference.inscattered(view, distance, settings, progress);
            if (!light) return light.error();
            truths.push_back({view, d, reference.transmittance(view.altitude, view.view_zenith, distance), std::move(*light)});
        }
    return truths;
}

AerialVerdict judged_aerial(const Sky& model, const std::vector<AerialTruth>& truths) {
    AerialVerdict verdict;
    std::array<Sums, aerial_distances_m.size()> sums;
    for (const AerialTruth& truth : truths) {
        ++verdict.at[truth.distance].asked;
        const Result<AerialPerspective> found = model.aerial_perspective(truth.view, aerial_distances_m[truth.distance] * m);
        if (!found) {
            if (verdict.refusal.empty()) verdict.refusal = found.error().what;
            continue;
        }
        ++verdict.at[truth.distance].answered;
        sums[truth.distance].add(truth, *found);
    }
    for (std::size_t d = 0; d < sums.size(); ++d) {
        const double n = std::max(1, sums[d].values);
        AerialScore& score = verdict.at[d];
        score.light_rmse = std::sqrt(std::max(0.0, sums[d].square - sums[d].variance) / n);
        score.noise = std::sqrt(sums[d].variance / n);
        score.transmittance_rmse = std::sqrt(sums[d].transmittance / n);
    }
    return verdict;
}

}  // namespace airlight
