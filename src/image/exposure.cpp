#include "image/exposure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace airlight {

namespace {

struct Metered {
    double luminance, weight;
};

Result<std::vector<Metered>> what_is_metered(std::span<const float> luminance, std::span<const float> weight, double sun_disk) {
    assert(weight.empty() || weight.size() == luminance.size());
    std::vector<Metered> metered;
    for (std::size_t i = 0; i < luminance.size(); ++i) {
        if (!(luminance[i] >= 0.0f)) return Error{"", fmt::format("pixel {} has luminance {}: it is not negative", i, luminance[i]), ""};
        const double w = weight.empty() ? 1.0 : static_cast<double>(weight[i]);
        if (luminance[i] > 0.0f && static_cast<double>(luminance[i]) < sun_disk && w > 0.0) metered.push_back({luminance[i], w});
    }
    if (metered.empty())
        return Error{"", "there is no light to meter: all pixels are black or the sun's disk", "Give the exposure as an EV or a white."};
    return metered;
}

double log_average(std::span<const Metered> metered) {
    double sum = 0.0, weights = 0.0;
    for (const Metered& m : metered) {
        sum += m.weight * std::log(m.luminance);
        weights += m.weight;
    }
    return std::exp(sum / weights);
}

// The luminance that `share` of the weight lies at or below.
double percentile(std::vector<Metered> metered, double share) {
    std::sort(metered.begin(), metered.end(), [](Metered a, Metered b) { return a.luminance < b.luminance; });
    double weights = 0.0;
    for (const Metered& m : metered) weights += m.weight;
    double below = 0.0;
    for (const Metered& m : metered) {
        below += m.weight;
        if (below >= share * weights) return m.luminance;
    }
    return metered.back().luminance;  // share is 1 and the sum rounds
}

}  // namespace

double exposure_of_white(double white) {
    assert(white > 0.0);
    return 1.0 / white;
}

double exposure_of_ev100(double ev100) { return 1.0 / (1.2 * std::exp2(ev100)); }
double ev100_of_exposure(double exposure) {
    assert(exposure > 0.0);
    return -std::log2(1.2 * exposure);
}

Result<double> metered_exposure(std::span<const float> luminance, std::span<const float> weight, const Metering& metering) {
    Result<std::vector<Metered>> metered = what_is_metered(luminance, weight, metering.sun_disk);
    if (!metered) return metered.error();
    if (metering.method == Metering::Method::log_average) return metering.grey / std::max(log_average(*metered), metering.darkest);
    return 1.0 / std::max(percentile(*std::move(metered), metering.share), metering.darkest);
}

}  // namespace airlight
