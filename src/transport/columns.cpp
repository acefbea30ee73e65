#include "transport/columns.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/parallel.h"
#include "core/quadrature.h"

namespace airlight {

namespace {

constexpr int points = 4;            // of Gauss's rule inside a shell
constexpr double node_step = 0.045;  // of the table, in the coordinate asinh(mu / cosine_scale): cubic interpolation errs by about 1e-7
constexpr int buckets = 4096;

struct Rule {
    double x[points];
    double w[points];
};
const Rule rule = [] {
    const GaussRule gauss = gauss_rule(points, 0.0, 1.0);
    Rule r{};
    std::copy(gauss.nodes.begin(), gauss.nodes.end(), r.x);
    std::copy(gauss.weights.begin(), gauss.weights.end(), r.w);
    return r;
}();

using Coefficients = std::array<double, 5>;

// The polynomial in z on [-1, 1] through the density at Chebyshev's points of [low, high].
Coefficients interpolating(const DensityProfile& profile, double low, double high) {
    Coefficients x{}, slope{}, power{};
    for (std::size_t i = 0; i < x.size(); ++i) {
        x[i] = std::cos(pi * (static_cast<double>(i) + 0.5) / 5.0);
        slope[i] = relative_density(profile, Length::of(0.5 * (low + high) + 0.5 * (high - low) * x[i]));
    }
    // Newton's divided differences, then expanded into powers of z.
    for (std::size_t k = 1; k < x.size(); ++k)
        for (std::size_t i = x.size() - 1; i >= k; --i) slope[i] = (slope[i] - slope[i - 1]) / (x[i] - x[i - k]);
    for (std::size_t k = x.size(); k-- > 0;) {
        for (std::size_t i = x.size() - 1; i > 0; --i) power[i] = power[i - 1] - x[k] * power[i];
        power[0] = slope[k] - x[k] * power[0];
    }
    return power;
}

double value(const Coefficients& p, double z) { return (((p[4] * z + p[3]) * z + p[2]) * z + p[1]) * z + p[0]; }

// Whether the polynomial follows the density over the whole of the shell: to 1e-7 of its value, or 1e-12 of the largest there is.
bool follows(const DensityProfile& profile, double low, double high, double largest) {
    const Coefficients p = interpolating(profile, low, high);
    double error = 0.0, size = 0.0;
    for (int i = 0; i < 12; ++i) {
        const double z = -1.0 + (i + 0.5) / 6.0;
        const double exact = relative_density(profile, Length::of(0.5 * (low + high) + 0.5 * (high - low) * z));
        error = std::max(error, std::abs(value(p, z) - exact));
        size = std::max(size, exact);
    }
    return error <= 1e-7 * size + 1e-12 * largest;
}

double largest_density(const DensityProfile& profile, double top) {
    double largest = 0.0;
    for (int i = 0; i <= 1000; ++i) largest = std::max(largest, relative_density(profile, Length::of(top * std::pow(i / 1000.0, 3.0))));
    for (const Length h : kinks(profile)) largest = std::max(largest, relative_density(profile, h));
    return largest;
}

}  // namespace

Columns::Columns(std::span<const DensityProfile> profiles, f64::Length bottom, f64::Length top)
    : bottom_(bottom.value), top_(top.value), count_(static_cast<int>(profiles.size())), stride_((count_ + 3) / 4 * 4) {
    assert(count_ <= max_columns && top_ > 0.0);
    divide(profiles);
    tabulate();
}

// Shells that end at every kink, no thicker than an eighth of the air or a fiftieth of the radius.
void Columns::divide(std::span<const DensityProfile> profiles) {
    std::vector<double> edges = {0.0, top_};
    for (const DensityProfile& profile : profiles)
        for (const Length h : kinks(profile))
            if (h.value > 1e-3 && h.value < top_ - 1e-3) edges.push_back(h.value);
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end(), [](double a, double b) { return b - a < 1e-3; }), edges.end());
    std::vector<double> largest;
    for (const DensityProfile& profile : profiles) largest.push_back(largest_density(profile, top_));
    const auto fine = [&](double low, double high) {
        if (high - low > std::min(top_ / 8.0, (bottom_ + low) / 50.0)) return false;
        if (high - low < 1e-6 * top_) return true;
        for (std::size_t c = 0; c < profiles.size(); ++c)
            if (!follows(profiles[c], low, high, largest[c])) return false;
        return true;
    };
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
        std::vector<double> ends = {edges[i + 1]};  // of the pieces still to be judged, the nearest last
        for (double low = edges[i]; !ends.empty();) {
            if (!fine(low, ends.back())) {
                ends.push_back(0.5 * (low + ends.back()));
                continue;
            }
            shells_.push_back({low, ends.back(), 0.5 * (low + ends.back()), 2.0 / (ends.back() - low)});
            low = ends.back();
            ends.pop_back();
        }
    }
    polynomials_.assign(shells_.size() * (degree + 1) * static_cast<std::size_t>(stride_), 0.0);
    for (std::size_t s = 0; s < shells_.size(); ++s)
        for (std::size_t c = 0; c < profiles.size(); ++c) {
            const Coefficients p = interpolating(profiles[c], shells_[s].low, shells_[s].high);
            for (std::size_t k = 0; k <= degree; ++k) polynomials_[(s * (degree + 1) + k) * static_cast<std::size_t>(stride_) + c] = p[k];
        }
    std::size_t s = 0;
    for (int b = 0; b <= buckets; ++b) {
        while (s + 1 < shells_.size() && shells_[s].high <= top_ * b / buckets) ++s;
        hints_.push_back(static_cast<int>(s));
    }
}

// Row by row from the top down: the columns above a shell's upper edge, by Gauss's rule through every shell above.
void Columns::tabulate() {
    double thinnest = top_;
    for (const Shell& shell : shells_) thinnest = std::min(thinnest, shell.high - shell.low);
    cosine_scale_ = std::min(0.5, 0.7 * std::sqrt(thinnest / (bottom_ + top_)));
    const double range = std::asinh(1.0 / cosine_scale_);
    nodes_ = std::max(8, static_cast<int>(std::ceil(range / node_step)) + 1);
    nodes_per_unit_ = (nodes_ - 1) / range;
    table_.assign(shells_.size() * static_cast<std::size_t>(nodes_ * stride_), 0.0);
    parallel_for(shells_.size() - 1, [&](std::size_t row) {
        for (int node = 0; node < nodes_; ++node) {
            const double mu = std::min(1.0, cosine_scale_ * std::sinh(node / nodes_per_unit_));
            double h = shells_[row].high;
            double q = (bottom_ + h) * mu;
            ColumnSet columns;
            for (std::size_t s = row + 1; s < shells_.size(); ++s) {
                const double gain = (shells_[s].high - h) * (2.0 * bottom_ + shells_[s].high + h);
                const double end = std::sqrt(q * q + gain);
                add_within(s, h, q, gain / (end + q), columns);
                h = shells_[s].high;
                q = end;
            }
            std::copy_n(
                columns.v, stride_,
                table_.begin() + static_cast<std::ptrdiff_t>((row * static_cast<std::size_t>(nodes_) + static_cast<std::size_t>(node)) *
                                                             static_cast<std::size_t>(stride_)));
        }
    });
}

const Columns::Shell& Columns::shell_at(double h) const {
    const int bucket = static_cast<int>(std::clamp(h / top_, 0.0, 1.0) * buckets);
    std::size_t s = static_cast<std::size_t>(hints_[static_cast<std::size_t>(bucket)]);
    // A bucket's first shell is found from its lower end, which rounding may put one shell too high.
    while (s > 0 && h < shells_[s].low) --s;
    while (s + 1 < shells_.size() && h >= shells_[s].high) ++s;
    return shells_[s];
}

// Altitude at distance t from a point at altitude h and distance q from the perigee.
double Columns::altitude(double h, double q, double t) const {
    const double r = bottom_ + h;
    const double gain = t * (2.0 * q + t);
    return std::clamp(h + gain / (std::sqrt(std::max(r * r + gain, 0.0)) + r), 0.0, top_);
}

// Adds the columns of a leg of length t that rises from (h, q) and stays in one shell.
void Columns::add_within(std::size_t shell, double h, double q, double t, ColumnSet& columns) const {
    const Shell& s = shells_[shell];
    const double r = bottom_ + h;
    double z[points];
    for (int k = 0; k < points; ++k) {
        const double x = t * rule.x[k];
        const double gain = x * (2.0 * q + x);
        z[k] = (h + gain / (std::sqrt(r * r + gain) + r) - s.centre) * s.per_half;
    }
    const double* p = &polynomials_[shell * static_cast<std::size_t>((degree + 1) * stride_)];
    for (int block = 0; block < stride_; block += 4) {
        double sum[4] = {0.0, 0.0, 0.0, 0.0};
        for (int k = 0; k < points; ++k)
            for (int c = 0; c < 4; ++c) {
                const double* a = p + block + c;
                sum[c] +=
                    rule.w[k] * ((((a[4 * stride_] * z[k] + a[3 * stride_]) * z[k] + a[2 * stride_]) * z[k] + a[stride_]) * z[k] + a[0]);
            }
        for (int c = 0; c < 4; ++c) columns.v[block + c] += t * sum[c];
    }
}

// Columns from (h, q >= 0) outwards to the top.
ColumnSet Columns::outwards(double h, double q) const {
    ColumnSet columns;
    if (h >= top_) return columns;
    const Shell& shell = shell_at(h);
    const std::size_t s = static_cast<std::size_t>(&shell - shells_.data());
    const double gain = (shell.high - h) * (2.0 * bottom_ + shell.high + h);
    const double end = std::sqrt(q * q + gain);
    if (end > 0.0) add_within(s, h, q, gain / (end + q), columns);
    if (s + 1 == shells_.size()) return columns;
    const double x = end / ((bottom_ + shell.high) * cosine_scale_);
    const double u = std::log(x + std::sqrt(x * x + 1.0)) * nodes_per_unit_;
    const int first = std::clamp(static_cast<int>(u) - 1, 0, nodes_ - 4);
    const double f = u - first;
    const double w[4] = {-(f - 1.0) * (f - 2.0) * (f - 3.0) / 6.0, f * (f - 2.0) * (f - 3.0) / 2.0, -f * (f - 1.0) * (f - 3.0) / 2.0,
                         f * (f - 1.0) * (f - 2.0) / 6.0};
    const double* a = &table_[(s * static_cast<std::size_t>(nodes_) + static_cast<std::size_t>(first)) * static_cast<std::size_t>(stride_)];
    for (int block = 0; block < stride_; block += 4)
        for (int c = block; c < block + 4; ++c)
            columns.v[c] += w[0] * a[c] + w[1] * a[stride_ + c] + w[2] * a[2 * stride_ + c] + w[3] * a[3 * stride_ + c];
    return columns;
}

ColumnSet Columns::density(double h) const {
    const Shell& shell = shell_at(h);
    const double z = (h - shell.centre) * shell.per_half;
    const double* p = &polynomials_[static_cast<std::size_t>(&shell - shells_.data()) * static_cast<std::size_t>((degree + 1) * stride_)];
    ColumnSet density;
    for (int block = 0; block < stride_; block += 4)
        for (int c = block; c < block + 4; ++c) {
            const double x = (((p[4 * stride_ + c] * z + p[3 * stride_ + c]) * z + p[2 * stride_ + c]) * z + p[stride_ + c]) * z + p[c];
            density.v[c] = x > 0.0 ? x : 0.0;
        }
    return density;
}

double Columns::sum(const ColumnSet& a, const ColumnSet& columns) const {
    double sums[4] = {0.0, 0.0, 0.0, 0.0};
    for (int block = 0; block < stride_; block += 4)
        for (int c = 0; c < 4; ++c) sums[c] += a.v[block + c] * columns.v[block + c];
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

namespace {

// times * a - b; rounding may not leave a column below zero.
ColumnSet difference(const ColumnSet& a, const ColumnSet& b, double times = 1.0) {
    ColumnSet d;
    for (int c = 0; c < max_columns; ++c) {
        const double x = times * a.v[c] - b.v[c];
        d.v[c] = x > 0.0 ? x : 0.0;
    }
    return d;
}

}  // namespace

ColumnSet Columns::to_top(double h, double mu) const {
    const double q = (bottom_ + h) * mu;
    if (mu >= 0.0) return outwards(h, q);
    return difference(outwards(altitude(h, q, -q), 0.0), outwards(h, -q), 2.0);
}

Columns::Ray Columns::ray(double h, double mu) const {
    const f64::Length h_(f64::Length::of(h)), bottom(f64::Length::of(bottom_)), top(f64::Length::of(top_));
    Ray ray;
    ray.h = h;
    ray.q = (bottom_ + h) * mu;
    ray.ground = f64::meets_ground(h_, mu, bottom);
    ray.start = outwards(h, std::abs(ray.q));
    if (mu >= 0.0) {
        ray.length = f64::distance_to_top(h_, mu, bottom, top).value;
        ray.low_h = h;
        ray.low_t = 0.0;
        ray.low = ray.total = ray.start;
    } else if (ray.ground) {
        ray.length = ray.low_t = f64::distance_to_ground(h_, mu, bottom).value;
        ray.low_h = 0.0;
        ray.low = outwards(0.0, -(ray.q + ray.length));
        ray.total = difference(ray.low, ray.start);
    } else {
        ray.length = f64::distance_to_top(h_, mu, bottom, top).value;
        ray.low_t = -ray.q;
        ray.low_h = altitude(h, ray.q, ray.low_t);
        ray.low = outwards(ray.low_h, 0.0);
        ray.total = difference(ray.low, ray.start, 2.0);
    }
    return ray;
}

Columns::Stop Columns::at_distance(const Ray& ray, double t) const {
    Stop stop;
    stop.t = t;
    stop.h = altitude(ray.h, ray.q, t);
    const ColumnSet here = outwards(stop.h, std::abs(ray.q + t));
    if (ray.q >= 0.0) stop.column = difference(ray.start, here);
    else if (t <= ray.low_t) stop.column = difference(here, ray.start);
    else stop.column = difference(ray.total, here);
    stop.density = density(stop.h);
    return stop;
}

// A rising leg from its lowest point: x is the distance from there.
struct Columns::Leg {
    double h, q;               // of the lowest point
    double low, high;          // range of x in which to look
    const ColumnSet* columns;  // outwards from the lowest point
};

// The distance x at which sum of a times the columns outwards falls to `level`; they and the densities there.
// Newton's method on the logarithm, which is straight in exponential air, inside a bracket that only shrinks.
double Columns::solve(const Leg& leg, const ColumnSet& a, double level, ColumnSet& columns, ColumnSet& densities) const {
    double low = leg.low, high = leg.high, x = 0.0, h = leg.h;
    level = std::max(level, 1e-300);
    columns = *leg.columns;
    densities = density(h);
    for (int step = 0; step < 60; ++step) {
        const double depth = sum(a, columns);
        const double slope = sum(a, densities);
        const double excess = depth - level;
        if (excess > 0.0) low = std::max(low, x);
        else high = std::min(high, x);
        const bool close = std::abs(excess) <= 2e-5 * level;
        double next = x + (slope > 0.0 ? (close ? excess : depth * std::log(depth / level)) / slope : 0.0);
        if (!(next >= low && next <= high) || slope <= 0.0 || step > 12) next = 0.5 * (low + high);
        else if (close) {
            // The last step is so short that the density does not change along it.
            for (int c = 0; c < stride_; ++c) columns.v[c] = std::max(0.0, columns.v[c] - (next - x) * densities.v[c]);
            return next;
        }
        x = next;
        h = altitude(leg.h, leg.q, x);
        columns = outwards(h, leg.q + x);
        densities = density(h);
        if (high - low <= 1e-10 * leg.high) break;
    }
    return x;
}

Columns::Stop Columns::at_depth(const Ray& ray, const ColumnSet& a, double depth) const {
    const double start = sum(a, ray.start);
    ColumnSet here;
    Stop stop;
    if (ray.q >= 0.0) {
        stop.t = solve({ray.h, ray.q, 0.0, ray.length, &ray.start}, a, start - depth, here, stop.density);
        stop.column = difference(ray.start, here);
    } else if (const double low = sum(a, ray.low); start + depth <= low || ray.ground) {
        stop.t = ray.low_t - solve({ray.low_h, std::max(0.0, -(ray.q + ray.low_t)), 0.0, ray.low_t, &ray.low}, a,
                                   std::min(start + depth, low), here, stop.density);
        stop.column = difference(here, ray.start);
    } else {
        stop.t =
            ray.low_t + solve({ray.low_h, 0.0, 0.0, ray.length - ray.low_t, &ray.low}, a, 2.0 * low - start - depth, here, stop.density);
        stop.column = difference(ray.total, here);
    }
    stop.t = std::clamp(stop.t, 0.0, ray.length);
    stop.h = altitude(ray.h, ray.q, stop.t);
    return stop;
}

}  // namespace airlight
