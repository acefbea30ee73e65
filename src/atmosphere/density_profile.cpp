#include "atmosphere/density_profile.h"

#include <algorithm>
#include <cmath>

#include "core/quadrature.h"
#include "physics/f64.h"

namespace airlight {

namespace {

f64::Length text_length(Length length) { return f64::Length::of(length.value); }

double density_of(const ExponentialProfile& p, Length h) {
    return h > p.top ? 0.0 : f64::exponential_density(text_length(h), text_length(p.scale_height)).value;
}
double density_of(const LayerProfile& p, Length h) {
    return f64::layer_density(text_length(h), text_length(p.low), text_length(p.high)).value;
}
double density_of(const TriangleProfile& p, Length h) {
    return f64::triangle_density(text_length(h), text_length(p.low), text_length(p.peak), text_length(p.high)).value;
}
double density_of(const TabulatedProfile& p, Length h) {
    const auto& samples = p.densities.samples();
    if (h <= samples.front().x) return samples.front().y.value;
    if (h > samples.back().x) return 0.0;
    const auto above = std::lower_bound(samples.begin(), samples.end(), h, [](const auto& s, Length x) { return s.x < x; });
    const auto& b = *above;
    const auto& a = *(above - 1);
    const double t = (h - a.x).value / (b.x - a.x).value;
    if (a.y.value > 0.0 && b.y.value > 0.0) return a.y.value * std::pow(b.y.value / a.y.value, t);
    return a.y.value * (1.0 - t) + b.y.value * t;
}

std::vector<Length> kinks_of(const ExponentialProfile& p) { return p.top < 1e9 * m ? std::vector{p.top} : std::vector<Length>{}; }
std::vector<Length> kinks_of(const LayerProfile& p) { return {p.low, p.high}; }
std::vector<Length> kinks_of(const TriangleProfile& p) { return {p.low, p.peak, p.high}; }
std::vector<Length> kinks_of(const TabulatedProfile& p) {
    std::vector<Length> altitudes;
    for (const auto& sample : p.densities.samples()) altitudes.push_back(sample.x);
    return altitudes;
}

std::vector<Length> jumps_of(const ExponentialProfile& p) { return kinks_of(p); }
std::vector<Length> jumps_of(const LayerProfile& p) { return kinks_of(p); }
std::vector<Length> jumps_of(const TriangleProfile&) { return {}; }
std::vector<Length> jumps_of(const TabulatedProfile& p) {
    const auto& last = p.densities.samples().back();
    return last.y.value > 0.0 ? std::vector{last.x} : std::vector<Length>{};
}

}  // namespace

double relative_density(const DensityProfile& profile, Length h) {
    return std::visit([&](const auto& p) { return density_of(p, h); }, profile);
}

std::vector<Length> kinks(const DensityProfile& profile) {
    return std::visit([](const auto& p) { return kinks_of(p); }, profile);
}

std::vector<Length> jumps(const DensityProfile& profile) {
    return std::visit([](const auto& p) { return jumps_of(p); }, profile);
}

Length column_depth(const DensityProfile& profile, Length top) {
    static const GaussRule rule = gauss_rule(5, 0.0, 1.0);
    std::vector<Length> ends = kinks(profile);
    // Pieces crowd towards the ground, where a scale height may be far smaller than the atmosphere.
    for (int i = 0; i <= 256; ++i) ends.push_back(std::pow(i / 256.0, 3.0) * top);
    std::sort(ends.begin(), ends.end());
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const double low = std::clamp(ends[i].value, 0.0, top.value);
        const double high = std::clamp(ends[i + 1].value, 0.0, top.value);
        for (std::size_t k = 0; k < rule.nodes.size(); ++k)
            sum += (high - low) * rule.weights[k] * relative_density(profile, Length::of(low + (high - low) * rule.nodes[k]));
    }
    return Length::of(sum);
}

}  // namespace airlight
