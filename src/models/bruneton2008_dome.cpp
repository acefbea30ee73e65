#include "models/bruneton2008_dome.h"

#include <algorithm>
#include <cmath>

#include "transport/pack_arithmetic.h"

namespace airlight {

namespace {

// Two neighbours in a row, and the weight of the second.
struct Between {
    std::size_t low;
    float weight;
};
AIRLIGHT_INLINE Between between(float x, int size) {
    const float inside = x > 0.0f ? (x < static_cast<float>(size - 1) ? x : static_cast<float>(size - 1)) : 0.0f;
    const int low = std::min(static_cast<int>(inside), size - 2);
    return {static_cast<std::size_t>(low), inside - static_cast<float>(low)};
}

template <class S>
AIRLIGHT_INLINE S mixed(const S* texels, std::size_t stride, const float* weights) {
    S sum;
    for (int w = 0; w < pack_size; ++w)
        sum.v[w] = weights[0] * texels[0].v[w] + weights[1] * texels[1].v[w] + weights[2] * texels[stride].v[w] +
                   weights[3] * texels[stride + 1].v[w];
    return sum;
}

}  // namespace

Bruneton2008Dome::Bruneton2008Dome(const Sky& sky, Packs packs, Length altitude, double sun_zenith)
    : sky_(sky), packs_(std::move(packs)), altitude_(altitude), sun_zenith_(sun_zenith) {
    h_ = f32::Length::of(static_cast<float>(altitude.in(m)));
    bottom_ = (*packs_)[0]->shape().bottom;
    top_ = (*packs_)[0]->shape().top;
    for (const auto& tables : *packs_) {
        cut_.push_back({tables->sky_slice(altitude.in(m), std::cos(sun_zenith)), PackPhases(tables->pack().optics)});
    }
}

// Above the horizon.
void Bruneton2008Dome::sky_radiance(float mu, double nu, float* radiance) const {
    const float x = f32::bruneton2008_sky_coordinate(h_, f32::Number::of(mu), bottom_, top_).value;
    const PackPhases::Place angle = PackPhases::place(nu);
    for (const Pack& pack : cut_) {
        const Bruneton2008Tables::Slice& slice = pack.slice;
        const Between view = between(x * static_cast<float>(slice.views - 1), slice.views);
        const Between across = between((0.5f + 0.5f * static_cast<float>(nu)) * static_cast<float>(slice.nus - 1), slice.nus);
        const auto stride = static_cast<std::size_t>(slice.nus);
        const std::size_t first = view.low * stride + across.low;
        const float weights[4] = {(1.0f - view.weight) * (1.0f - across.weight), (1.0f - view.weight) * across.weight,
                                  view.weight * (1.0f - across.weight), view.weight * across.weight};
        f32::RadianceSpectrum sum = mixed(&slice.multiple[first], stride, weights);
        for (std::size_t p = 0; p < pack.phases.parts().size(); ++p)
            pack.phases.add(angle, p, mixed(&slice.single[p][first], stride, weights), sum);
        std::copy(sum.v, sum.v + pack.phases.wavelength_count(), radiance);
        radiance += pack.phases.wavelength_count();
    }
}

void Bruneton2008Dome::radiance(double view_zenith, double relative_azimuth, std::span<float> radiance) const {
    const Direction one{view_zenith, relative_azimuth};
    radiances({&one, 1}, radiance);
}

void Bruneton2008Dome::radiances(std::span<const Direction> directions, std::span<float> radiance) const {
    const double mu_s = std::cos(sun_zenith_), sin_s = std::sin(sun_zenith_);
    const std::size_t count = directions.empty() ? 0 : radiance.size() / directions.size();
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const Direction& d = directions[i];
        const double mu = std::cos(d.view_zenith);
        float* seen = &radiance[i * count];
        if (!f32::meets_ground(h_, f32::Number(mu), bottom_)) {
            const double sine = std::sqrt((1.0 - mu) * (1.0 + mu));
            const double nu = std::clamp(mu * mu_s + sine * sin_s * std::cos(d.relative_azimuth), -1.0, 1.0);
            sky_radiance(static_cast<float>(mu), nu, seen);
            continue;
        }
        const Result<RadianceEstimate> asked = sky_.radiance({altitude_, d.view_zenith, sun_zenith_, d.relative_azimuth});
        for (std::size_t w = 0; w < count; ++w) seen[w] = asked ? static_cast<float>(asked->radiance_W_m2_sr_nm[w]) : 0.0f;
    }
}

}  // namespace airlight
