#include "transport/reference_sampling.h"

#include <algorithm>

#include "core/quadrature.h"

namespace airlight {

namespace {

constexpr int bins = 512;

}  // namespace

DirectionSampler::DirectionSampler(const SpectralPhase& phase) {
    static const GaussRule rule = gauss_rule(4, 0.0, 1.0);
    for (int k = 0; k <= bins; ++k) edges_.push_back(std::cos(pi * (k * static_cast<double>(k)) / (bins * static_cast<double>(bins))));
    f64::Spectrum total(f64::Number(0.0));
    for (int k = 0; k < bins; ++k) {
        const double width = edges_[static_cast<std::size_t>(k)] - edges_[static_cast<std::size_t>(k) + 1];
        f64::PhaseSpectrum mean(0.0 * f64::per_sr);
        for (std::size_t i = 0; i < rule.nodes.size(); ++i)
            mean += phase.at(edges_[static_cast<std::size_t>(k)] - rule.nodes[i] * width) * f64::Number(rule.weights[i]);
        density_.push_back(mean);
        total += mean / f64::per_sr * f64::Number(2.0 * pi * width);
    }
    cumulative_.resize(static_cast<std::size_t>(pack_size * bins));
    f64::Spectrum sum(f64::Number(0.0));
    for (int k = 0; k < bins; ++k) {
        const double width = edges_[static_cast<std::size_t>(k)] - edges_[static_cast<std::size_t>(k) + 1];
        f64::PhaseSpectrum& density = density_[static_cast<std::size_t>(k)];
        density = density / total;
        sum += density / f64::per_sr * f64::Number(2.0 * pi * width);
        for (int l = 0; l < pack_size; ++l) cumulative_[static_cast<std::size_t>(l * bins + k)] = sum.v[l];
    }
}

DirectionSampler::Draw DirectionSampler::draw(int wavelength, double u, double within) const {
    const auto first = cumulative_.begin() + wavelength * bins;
    const auto found = std::upper_bound(first, first + bins - 1, u * first[bins - 1]);
    const std::size_t k = static_cast<std::size_t>(found - first);
    return {edges_[k] + (edges_[k + 1] - edges_[k]) * within, static_cast<int>(k)};
}

SunSampler::SunSampler(const Sun& sun, std::span<const Wavelength, pack_size> wavelengths)
    : cap_(2.0 * std::pow(std::sin(0.5 * sun.angular_radius), 2)) {
    for (int i = 0; i < pack_size; ++i) {
        const Wavelength w = wavelengths[static_cast<std::size_t>(i)];
        u1_.v[i] = sun.limb_darkening_1.at(w).value;
        u2_.v[i] = sun.limb_darkening_2.at(w).value;
        // The mean over the disk of 1 - u1 (1 - mu) - u2 (1 - mu)^2.
        mean_.v[i] = 1.0 - u1_.v[i] / 3.0 - u2_.v[i] / 6.0;
    }
}

f64::Spectrum SunSampler::weight(double u) const {
    // u is the share of the disk inside the point; mu the cosine at which the ray leaves the sun's surface.
    const f64::Number x = 1.0 - std::sqrt(std::max(0.0, 1.0 - u));
    return (f64::Spectrum(f64::Number(1.0)) - u1_ * x - u2_ * (x * x)) / mean_;
}

}  // namespace airlight
