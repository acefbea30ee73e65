#include "models/dobashi1997_series.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/parallel.h"
#include "core/quadrature.h"

namespace airlight {

namespace {

constexpr double suns_deg[] = {0, 5, 10, 15, 20, 25, 30, 35, 40, 45, 50, 55, 60, 65, 70, 75, 80, 83, 86, 88, 90};
constexpr double bands_deg[] = {0, 5, 10, 15, 20, 25, 30, 35, 40, 45, 50, 55, 60, 65, 70, 75, 80, 83, 86, 88, 90};
constexpr double lowest_view_deg = 89.95;  // stands for 90, where an eye on the ground sees the ground
constexpr int azimuths = 64;               // of cosines and harmonics
constexpr int steps = 36;                  // of samples
constexpr int cosines = 32;                // of zenith angles, by Gauss's rule: exact for products of two harmonics of degree 31

double azimuth(int k) { return pi * (k + 0.5) / azimuths; }
double scale(int i) { return std::sqrt((i == 0 ? 1.0 : 2.0) / pi); }  // c_i

const GaussRule& cosine_rule() {
    static const GaussRule rule = gauss_rule(cosines, 0.0, 1.0);
    return rule;
}

std::vector<Direction> directions_of(SkyBasis basis) {
    std::vector<Direction> all;
    if (basis == SkyBasis::harmonics) {
        for (const double mu : cosine_rule().nodes)
            for (int k = 0; k < azimuths; ++k) all.push_back({std::acos(mu), azimuth(k)});
        return all;
    }
    const bool samples = basis == SkyBasis::samples;
    for (const double band : bands_deg)
        for (int k = 0; k < (samples ? steps + 1 : azimuths); ++k)
            all.push_back({std::min(band, lowest_view_deg) * deg, samples ? pi * k / steps : azimuth(k)});
    return all;
}

double square_of(std::span<const double> radiances) {
    double square = 0.0;
    for (const double l : radiances) square += l * l * pi / static_cast<double>(radiances.size());
    return square;
}

// W_i of each order below `count`.
std::vector<double> cosine_weights(std::span<const double> radiances, int count) {
    const double step = pi / static_cast<double>(radiances.size());
    std::vector<double> weights(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        for (std::size_t k = 0; k < radiances.size(); ++k)
            weights[static_cast<std::size_t>(i)] += scale(i) * std::cos(i * step * (static_cast<double>(k) + 0.5)) * radiances[k] * step;
    return weights;
}

// The weights of harmonics [order][(degree - order) / 2], of a sky that its mirror image below the horizon completes.
BandSeries harmonic_weights(std::span<const double> radiances, int degree) {
    BandSeries weights;
    for (int m = 0; m <= degree; ++m) weights.emplace_back(static_cast<std::size_t>((degree - m) / 2 + 1));
    const GaussRule& rule = cosine_rule();
    for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
        const std::vector<double> orders = cosine_weights(radiances.subspan(j * azimuths, azimuths), degree + 1);
        for (int m = 0; m <= degree; ++m) {
            const std::vector<double> functions = legendre_functions(m, degree, rule.nodes[j]);
            const auto order = static_cast<std::size_t>(m);
            for (std::size_t i = 0; i < functions.size(); ++i) weights[order][i] += 2.0 * rule.weights[j] * orders[order] * functions[i];
        }
    }
    return weights;
}

// The factors of the fewest degrees whose error is at most `error`.
BandSeries harmonic_factors(std::span<const double> radiances, double error, int most) {
    const GaussRule& rule = cosine_rule();
    double square = 0.0;
    for (std::size_t j = 0; j < rule.nodes.size(); ++j)
        square += 2.0 * rule.weights[j] * square_of(radiances.subspan(j * azimuths, azimuths));
    const BandSeries weights = harmonic_weights(radiances, most);
    BandSeries factors(static_cast<std::size_t>(most) + 1);
    double rest = square;
    for (int l = 0; l <= most && rest > error * square; ++l)
        for (int m = l % 2; m <= l; m += 2) {
            const auto order = static_cast<std::size_t>(m), i = static_cast<std::size_t>((l - m) / 2);
            rest -= weights[order][i] * weights[order][i];
            factors[order].push_back(scale(m) * weights[order][i]);
        }
    return factors;
}

BandSeries bands_of(std::span<const double> radiances, const Dobashi1997Settings& settings) {
    if (settings.basis == SkyBasis::harmonics) return harmonic_factors(radiances, settings.error, settings.most_degree);
    BandSeries series;
    const std::size_t count = radiances.size() / std::size(bands_deg);
    for (std::size_t b = 0; b < std::size(bands_deg); ++b) {
        const std::span<const double> band = radiances.subspan(b * count, count);
        series.push_back(settings.basis == SkyBasis::samples ? std::vector<double>(band.begin(), band.end())
                                                             : cosine_factors(band, settings.error, settings.most_functions));
    }
    return series;
}

std::vector<double> bands_named(const Dobashi1997Settings& settings) {
    if (settings.basis != SkyBasis::harmonics) return {std::begin(bands_deg), std::end(bands_deg)};
    std::vector<double> orders;
    for (int m = 0; m <= settings.most_degree; ++m) orders.push_back(m);
    return orders;
}

}  // namespace

std::vector<double> cosine_factors(std::span<const double> radiances, double error, int most) {
    const double square = square_of(radiances);
    const std::vector<double> weights = cosine_weights(radiances, std::min(most, static_cast<int>(radiances.size())));
    std::vector<double> factors;
    double rest = square;
    for (std::size_t i = 0; i < weights.size() && (i == 0 || rest > error * square); ++i) {
        factors.push_back(scale(static_cast<int>(i)) * weights[i]);
        rest -= weights[i] * weights[i];
    }
    return factors;
}

double cosine_error(std::span<const double> radiances, std::span<const double> factors) {
    const double square = square_of(radiances);
    double rest = square;
    for (std::size_t i = 0; i < factors.size(); ++i) rest -= std::pow(factors[i] / scale(static_cast<int>(i)), 2);
    return square > 0.0 ? rest / square : 0.0;
}

std::vector<View> dobashi1997_views(const Dobashi1997Settings& settings) {
    std::vector<View> views;
    for (const double sun : suns_deg)
        for (const Direction& d : directions_of(settings.basis))
            views.push_back({settings.altitude, d.view_zenith, sun * deg, d.relative_azimuth});
    return views;
}

Dobashi1997Data dobashi1997_series(std::span<const double> radiances, std::span<const Wavelength> wavelengths,
                                   const Dobashi1997Settings& settings) {
    Dobashi1997Data data{
        settings.basis, settings.altitude.in(m), {}, {std::begin(suns_deg), std::end(suns_deg)}, bands_named(settings), {}};
    for (const Wavelength w : wavelengths) data.wavelengths_nm.push_back(w.in(nm));
    const std::size_t n = wavelengths.size(), suns = std::size(suns_deg), directions = radiances.size() / n / suns;
    data.skies.resize(n * suns);
    parallel_for(n * suns, [&](std::size_t i) {
        const std::size_t w = i / suns, s = i % suns;
        std::vector<double> sky(directions);
        for (std::size_t d = 0; d < directions; ++d) sky[d] = radiances[(s * directions + d) * n + w];
        data.skies[i] = bands_of(sky, settings);
    });
    return data;
}

Result<Dobashi1997Data> dobashi1997_series(const Sky& sky, const Dobashi1997Settings& settings, const Progress& progress) {
    const std::vector<View> views = dobashi1997_views(settings);
    const std::size_t n = sky.wavelengths().size();
    std::vector<double> radiances(views.size() * n);
    std::vector<std::optional<Error>> errors(views.size());
    parallel_for(views.size(), [&](std::size_t i) {
        if (progress.stop.stop_requested()) {
            errors[i] = Error{"", "the series were interrupted", ""};
            return;
        }
        const Result<RadianceEstimate> seen = sky.radiance(views[i]);
        if (!seen) errors[i] = seen.error();
        else std::copy(seen->radiance_W_m2_sr_nm.begin(), seen->radiance_W_m2_sr_nm.end(), &radiances[i * n]);
    });
    for (const std::optional<Error>& error : errors)
        if (error) return *error;
    return dobashi1997_series(radiances, sky.wavelengths(), settings);
}

}  // namespace airlight
