#include "fit/hosek2012_form.h"

#include <algorithm>
#include <cmath>

#include "fit/least_squares.h"
#include "physics/models/f64.h"

namespace airlight {

namespace {

enum Coefficient : std::size_t { A, B, C, D, E, F, G, H, I, mean };

constexpr std::size_t coefficient_count = std::size(hosek2012_coefficients);
using Coefficients = std::array<double, coefficient_count>;

// What of a direction does not depend on the coefficients.
struct Geometry {
    double mu, gamma, nu2, root_mu;
    Geometry(double mu_, double gamma_) : mu(mu_), gamma(gamma_), nu2(std::cos(gamma_) * std::cos(gamma_)), root_mu(std::sqrt(mu_)) {}
};

double haze(const Geometry& g, double i) { return (1.0 + g.nu2) / std::pow(1.0 + i * i - 2.0 * i * std::cos(g.gamma), 1.5); }
double gradation(const Geometry& g, const Coefficients& k) { return 1.0 + k[A] * std::exp(k[B] / (g.mu + 0.01)); }
double scattering(const Geometry& g, const Coefficients& k) {
    return k[C] + k[D] * std::exp(k[E] * g.gamma) + k[F] * g.nu2 + k[G] * haze(g, k[I]) + k[H] * g.root_mu;
}
double value(const Geometry& g, const Coefficients& k) {
    const f64::Hosek2012 text{k[A], k[B], k[C], k[D], k[E], k[F], k[G], k[H], k[I], k[mean]};
    return f64::hosek2012_radiance(text, g.mu, std::cos(g.gamma), g.gamma).value;
}

// By each coefficient.
Coefficients slopes(const Geometry& g, const Coefficients& k) {
    const double e1 = std::exp(k[B] / (g.mu + 0.01)), e2 = std::exp(k[E] * g.gamma);
    const double p = gradation(g, k), s = scattering(g, k), c = std::cos(g.gamma);
    Coefficients d{};
    d[A] = k[mean] * e1 * s;
    d[B] = k[mean] * k[A] * e1 / (g.mu + 0.01) * s;
    d[C] = k[mean] * p;
    d[D] = k[mean] * p * e2;
    d[E] = k[mean] * p * k[D] * g.gamma * e2;
    d[F] = k[mean] * p * g.nu2;
    d[G] = k[mean] * p * haze(g, k[I]);
    d[H] = k[mean] * p * g.root_mu;
    d[I] = -3.0 * k[mean] * p * k[G] * haze(g, k[I]) * (k[I] - c) / (1.0 + k[I] * k[I] - 2.0 * k[I] * c);
    d[mean] = p * s;
    return d;
}

// Unbounded numbers stand for the coefficients that have bounds: B < 0, or the horizon would be a pole; 0 < I < 1, or the sun's
// place would be; E below 0.5, or the side of the sky away from the sun swings between the suns of the fit (with E up to 9 by
// a factor of two). A curve stays between its control points, so bounds on these are enough.
constexpr double most_e = 0.5;
constexpr double most_i = 0.98;
double distance_to_bound(double u) { return std::exp(std::clamp(u, -6.0, 4.0)); }
double bounded(std::size_t k, double u) {
    if (k == B) return -distance_to_bound(u);
    if (k == E) return most_e - distance_to_bound(u);
    if (k == I) return most_i / (1.0 + std::exp(-u));
    return u;
}
double unbounded(std::size_t k, double x) {
    if (k == B) return std::log(std::max(-x, 1e-2));
    if (k == E) return std::log(std::max(most_e - x, 1e-2));
    if (k == I) return -std::log(most_i / std::clamp(x, 0.01, most_i - 0.01) - 1.0);
    return x;
}
double bounded_slope(std::size_t k, double u) {
    if (k == B || k == E) return u > -6.0 && u < 4.0 ? -std::exp(u) : 0.0;
    if (k == I) return bounded(I, u) * (1.0 - bounded(I, u) / most_i);
    return 1.0;
}

// A search for the control points: the same one for every sun, or all six. The mean always has six, in units of `unit`.
class Search {
public:
    Search(std::span<const HosekSample> samples, int points, double unit) : points_(static_cast<std::size_t>(points)), unit_(unit) {
        for (const HosekSample& s : samples)
            rows_.push_back({Geometry(s.mu, s.gamma), bezier_weights(s.sun_zenith), std::sqrt(s.weight), s.radiance});
    }

    // The parameters' place of a control point.
    std::size_t place(std::size_t k, std::size_t point) const { return k * points_ + point; }
    std::size_t points_of(std::size_t k) const { return k == mean ? bezier_points : points_; }
    std::size_t parameters() const { return mean * points_ + bezier_points; }

    std::vector<double> parameters_of(const HosekCurves& curves) const {
        std::vector<double> x(parameters());
        for (std::size_t k = 0; k < coefficient_count; ++k)
            for (std::size_t i = 0; i < points_of(k); ++i) x[place(k, i)] = k == mean ? curves[k][i] / unit_ : unbounded(k, curves[k][i]);
        return x;
    }
    HosekCurves curves_of(std::span<const double> x) const {
        HosekCurves curves;
        for (std::size_t k = 0; k < coefficient_count; ++k)
            for (std::size_t i = 0; i < bezier_points; ++i) {
                const double u = x[place(k, points_of(k) == 1 ? 0 : i)];
                curves[k][i] = k == mean ? u * unit_ : bounded(k, u);
            }
        return curves;
    }

    // From `start`, to which flat directions are tied by a spring; stiffer for what the form is not linear in.
    HosekCurves from(const HosekCurves& start, double spring, int evaluations, double stiffness = 1.0) const {
        const std::vector<double> x0 = parameters_of(start);
        const std::size_t n = x0.size(), m = rows_.size() + n;
        std::vector<double> springs(n, spring * stiffness);
        for (const std::size_t k : {C, D, F, G, H})
            for (std::size_t i = 0; i < points_of(k); ++i) springs[place(k, i)] = spring;
        LeastSquares problem{.residuals = static_cast<int>(m), .evaluate = {}, .evaluations = evaluations, .tolerance = 1e-5};
        problem.evaluate = [&](std::span<const double> x, std::span<double> r) {
            const HosekCurves curves = curves_of(x);
            for (std::size_t i = 0; i < rows_.size(); ++i)
                r[i] = rows_[i].weight * (value(rows_[i].geometry, at(curves, i)) / rows_[i].truth - 1.0);
            for (std::size_t j = 0; j < n; ++j) r[rows_.size() + j] = springs[j] * (x[j] - x0[j]);
        };
        problem.differentiate = [&](std::span<const double> x, std::span<double> d) {
            std::fill(d.begin(), d.end(), 0.0);
            const HosekCurves curves = curves_of(x);
            for (std::size_t i = 0; i < rows_.size(); ++i) {
                const Coefficients by = slopes(rows_[i].geometry, at(curves, i));
                for (std::size_t k = 0; k < coefficient_count; ++k)
                    for (std::size_t p = 0; p < bezier_points; ++p) {
                        const std::size_t j = place(k, points_of(k) == 1 ? 0 : p);
                        const double chain = k == mean ? unit_ : bounded_slope(k, x[j]);
                        d[j * m + i] += rows_[i].weight / rows_[i].truth * by[k] * rows_[i].bezier[p] * chain;
                    }
            }
            for (std::size_t j = 0; j < n; ++j) d[j * m + rows_.size() + j] = springs[j];
        };
        return curves_of(least_squares(problem, x0).parameters);
    }

private:
    struct Row {
        Geometry geometry;
        std::array<double, bezier_points> bezier;
        double weight;
        double truth;
    };
    Coefficients at(const HosekCurves& curves, std::size_t row) const {
        Coefficients k{};
        for (std::size_t c = 0; c < coefficient_count; ++c)
            for (std::size_t p = 0; p < bezier_points; ++p) k[c] += curves[c][p] * rows_[row].bezier[p];
        return k;
    }

    std::vector<Row> rows_;
    std::size_t points_;
    double unit_;
};

// A bluish sky, brighter at the horizon and around the sun, in units of its mean.
HosekCurves some_sky(double unit) {
    constexpr Coefficients k{-1.0, -0.3, 0.6, 2.0, -3.0, 0.4, 0.1, 0.4, 0.6, 1.0};
    HosekCurves curves;
    for (std::size_t i = 0; i < coefficient_count; ++i) curves[i].fill(i == mean ? unit : k[i]);
    return curves;
}

}  // namespace

std::array<double, bezier_points> bezier_weights(double sun_zenith) {
    const f64::Number s = f64::hosek2012_place(sun_zenith);
    std::array<double, bezier_points> weights;
    for (std::size_t i = 0; i < bezier_points; ++i) {
        const auto p = [i](std::size_t k) { return i == k ? 1.0 : 0.0; };
        weights[i] = f64::quintic_bezier(p(0), p(1), p(2), p(3), p(4), p(5), s).value;
    }
    return weights;
}

double hosek_radiance(const HosekCurves& curves, double sun_zenith, double mu, double gamma) {
    const auto weights = bezier_weights(sun_zenith);
    Coefficients k{};
    for (std::size_t c = 0; c < coefficient_count; ++c)
        for (std::size_t p = 0; p < bezier_points; ++p) k[c] += curves[c][p] * weights[p];
    return value(Geometry(mu, gamma), k);
}

HosekCurves fitted_hosek(std::span<const HosekSample> samples, const HosekCurves* similar) {
    double unit = 0.0;
    for (const HosekSample& s : samples) unit += s.radiance / static_cast<double>(samples.size());
    // A change of a parameter by one costs as much as a difference of 10 % in one direction. From a similar sky it costs ten times as
    // much for what the form is not linear in: so what changes from one turbidity to the next is linear, and its mean is the sky between.
    constexpr double spring = 0.1;
    if (!similar) {
        const HosekCurves alike = Search(samples, 1, unit).from(some_sky(unit), 2.0 * spring, 60);
        return Search(samples, bezier_points, unit).from(alike, spring, 60);
    }
    return Search(samples, bezier_points, unit).from(*similar, spring, 60, 10.0);
}

}  // namespace airlight
