#include "transport/ray_nodes.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "core/quadrature.h"

namespace airlight {

namespace {

// Gauss's rule on [0, 1], and the integrals from 0 to each node of the polynomial through all nodes.
struct PieceRule {
    int count;
    std::array<double, RayNodes::max_per_piece> node;
    std::array<double, RayNodes::max_per_piece> weight;
    std::array<std::array<float, RayNodes::max_per_piece>, RayNodes::max_per_piece> up_to;  // [node][sample]
};

PieceRule piece_rule(int n) {
    PieceRule rule{};
    rule.count = n;
    const InterpolatingRule gauss = interpolating_rule(n);
    for (std::size_t k = 0; k < static_cast<std::size_t>(n); ++k) {
        rule.node[k] = gauss.nodes[k];
        rule.weight[k] = gauss.weights[k];
        std::transform(gauss.up_to[k].begin(), gauss.up_to[k].end(), rule.up_to[k].begin(), [](double x) { return static_cast<float>(x); });
    }
    return rule;
}

const PieceRule& rule_of(int n) {
    static const std::vector<PieceRule> rules = [] {
        std::vector<PieceRule> all;
        for (int i = 2; i <= RayNodes::max_per_piece; ++i) all.push_back(piece_rule(i));
        return all;
    }();
    return rules[static_cast<std::size_t>(n - 2)];
}

// A ray by the signed distance x from its perigee; it runs towards larger x.
struct Path {
    double bottom;
    double r0;  // radius at the start
    double h0;
    double x0;

    double altitude(double x) const {
        const double gain = (x - x0) * (x + x0);
        return std::max(0.0, h0 + gain / (std::sqrt(std::max(r0 * r0 + gain, 0.0)) + r0));
    }
};

// Where a path is cut into pieces: increasing ends, in x.
class Cuts {
public:
    Cuts(double first, double last) : first_(first), last_(last) {}

    // Adds an end within the path; one that would leave less than a billionth of it holds no air and is left out.
    void add(double x) {
        const double least = 1e-9 * (last_ - first_);
        if (!(x > first_ + least && x < last_ - least) || count_ == inner_.size()) return;
        std::size_t i = count_++;
        for (; i > 0 && inner_[i - 1] > x; --i) inner_[i] = inner_[i - 1];
        inner_[i] = x;
    }
    std::size_t pieces() const { return count_ + 1; }
    double start(std::size_t piece) const { return piece == 0 ? first_ : inner_[piece - 1]; }
    double end(std::size_t piece) const { return piece == count_ ? last_ : inner_[piece]; }

private:
    double first_;
    double last_;
    std::size_t count_ = 0;
    std::array<double, RayNodes::max_pieces - 1> inner_{};
};

// The shortest mean free path just above or below an altitude: densities may jump there.
double free_path_beside(double altitude, bool above, const DensityTable& densities, const Opacity& opacity) {
    float density[max_parts];
    densities.at(static_cast<float>(altitude * (above ? 1.0 + 1e-6 : 1.0 - 1e-6)), density);
    double extinction = 0.0;
    for (int p = 0; p < densities.parts(); ++p)
        extinction += static_cast<double>(density[p]) * static_cast<double>(opacity[static_cast<std::size_t>(p)]);
    return 1.0 / std::max(extinction, 1e-12);
}

Cuts cuts_of(const Shell& shell, const Ray& ray, const Path& path, double length, const DensityTable& densities, const Opacity& opacity) {
    Cuts cuts(path.x0, path.x0 + length);
    // Beyond some free paths little is seen: cuts there, unless little of the ray is left.
    const auto add_free_paths = [&](double x, double altitude) {
        const double free_path = free_path_beside(altitude, x >= 0.0, densities, opacity);
        const double left = path.x0 + length - x;
        for (const double t : {2.0 * free_path, 12.0 * free_path})
            if (x >= path.x0 && t < 0.25 * left) cuts.add(x + t);
    };
    cuts.add(0.0);
    const double a = 1.0 - ray.nu * ray.nu;
    const double b = path.r0 * (ray.mu - ray.mu_s * ray.nu);
    for (const double share : shadow_edges) {
        const double above = share * shell.top_m;
        const double c = (path.h0 - above) * (2.0 * shell.bottom_m + path.h0 + above) - path.r0 * path.r0 * ray.mu_s * ray.mu_s;
        const double discriminant = b * b - a * c;
        if (a < 1e-12 || discriminant <= 0.0) continue;
        const double root = std::sqrt(discriminant);
        for (const double t : {(-b - root) / a, (-b + root) / a})
            if (path.r0 * ray.mu_s + ray.nu * t < 0.0) cuts.add(path.x0 + t);
    }
    // Jumps first: they have to be cut, the rest helps.
    const auto for_each_jump = [&](auto&& visit) {
        for (const double altitude : densities.jumps_m()) {
            const double squared = path.x0 * path.x0 + (altitude - path.h0) * (2.0 * shell.bottom_m + altitude + path.h0);
            if (squared <= 0.0) continue;
            visit(std::sqrt(squared), altitude);
            visit(-std::sqrt(squared), altitude);
        }
    };
    for_each_jump([&](double x, double) { cuts.add(x); });
    for_each_jump(add_free_paths);
    add_free_paths(path.x0, path.h0);
    return cuts;
}

// Appends the nodes of the piece [x_a, x_b], on one side of the perigee; `start` holds the columns before it and receives those after it.
void add_piece(const Shell& shell, const Ray& ray, const Path& path, double x_a, double x_b, const PieceRule& rule,
               const DensityTable& densities, float* start, RayNodes& nodes) {
    const bool rises = x_a + x_b > 0.0;
    const double x_low = rises ? std::max(x_a, 0.0) : std::min(x_b, 0.0);
    const double h_low = path.altitude(x_low);
    const double rise = path.altitude(rises ? x_b : x_a) - h_low;
    const int first = nodes.count;
    for (int k = 0; k < rule.count; ++k) {
        const auto i = static_cast<std::size_t>(k);
        const double u = rises ? rule.node[i] : 1.0 - rule.node[i];
        const double h = h_low + rise * u * u;
        const double x = std::sqrt(x_low * x_low + rise * u * u * (2.0 * shell.bottom_m + h + h_low));
        const double slope = 2.0 * rise * (shell.bottom_m + h) * u / x;  // d|x| / du
        const double t = (rises ? x : -x) - path.x0;
        const int n = first + k;
        nodes.altitude_m[n] = static_cast<float>(h);
        nodes.mu[n] = static_cast<float>(std::clamp((rises ? x : -x) / (shell.bottom_m + h), -1.0, 1.0));
        nodes.mu_s[n] = static_cast<float>(std::clamp((path.r0 * ray.mu_s + ray.nu * t) / (shell.bottom_m + h), -1.0, 1.0));
        nodes.distance_m[n] = static_cast<float>(t);
        nodes.length_m[n] = static_cast<float>(rule.weight[i] * slope);
        densities.at(nodes.altitude_m[n], nodes.density[n]);
        for (int p = 0; p < densities.parts(); ++p) nodes.column_m[n][p] = static_cast<float>(slope) * nodes.density[n][p];
    }
    // The columns so far hold slope times density: integrate them along the piece.
    for (int p = 0; p < densities.parts(); ++p) {
        float rate[RayNodes::max_per_piece];
        float whole = 0.0f;
        for (int j = 0; j < rule.count; ++j) {
            rate[j] = nodes.column_m[first + j][p];
            whole += static_cast<float>(rule.weight[static_cast<std::size_t>(j)]) * rate[j];
        }
        for (int k = 0; k < rule.count; ++k) {
            float sum = start[p];
            for (int j = 0; j < rule.count; ++j) sum += rule.up_to[static_cast<std::size_t>(k)][static_cast<std::size_t>(j)] * rate[j];
            nodes.column_m[first + k][p] = std::max(sum, 0.0f);
        }
        start[p] += whole;
    }
    nodes.count += rule.count;
}

}  // namespace

void sample_ray(const Shell& shell, const Ray& ray, const DensityTable& densities, const Opacity& opacity, int nodes_per_piece,
                RayNodes& nodes) {
    assert(nodes_per_piece >= 2 && nodes_per_piece <= RayNodes::max_per_piece);
    const f64::Length h = f64::Length::of(ray.altitude_m);
    const f64::Length bottom = f64::Length::of(shell.bottom_m);
    const f64::Length top = f64::Length::of(shell.top_m);
    nodes.count = 0;
    nodes.meets_ground = f64::meets_ground(h, ray.mu, bottom);
    double length =
        nodes.meets_ground ? f64::distance_to_ground(h, ray.mu, bottom).value : f64::distance_to_top(h, ray.mu, bottom, top).value;
    if (ray.limit_m < length) {
        length = ray.limit_m;
        nodes.meets_ground = false;
    }

    const Path path{shell.bottom_m, shell.bottom_m + ray.altitude_m, ray.altitude_m, (shell.bottom_m + ray.altitude_m) * ray.mu};
    nodes.end_distance_m = static_cast<float>(length);
    nodes.end_altitude_m = static_cast<float>(path.altitude(path.x0 + length));
    nodes.end_mu_s = static_cast<float>(
        std::clamp((path.r0 * ray.mu_s + ray.nu * length) / (shell.bottom_m + path.altitude(path.x0 + length)), -1.0, 1.0));
    std::fill(nodes.total_column_m, nodes.total_column_m + max_parts, 0.0f);
    if (!(length > 0.0)) return;

    const Cuts cuts = cuts_of(shell, ray, path, length, densities, opacity);
    const PieceRule& rule = rule_of(nodes_per_piece);
    for (std::size_t i = 0; i < cuts.pieces(); ++i)
        add_piece(shell, ray, path, cuts.start(i), cuts.end(i), rule, densities, nodes.total_column_m, nodes);
}

bool enter_air(const Shell& shell, Ray& ray) {
    if (ray.altitude_m <= shell.top_m) return true;
    const double r = shell.bottom_m + ray.altitude_m;
    const double top = shell.bottom_m + shell.top_m;
    // Squared distance from the perigee to the shell; the perigee is above the air if it is negative.
    const double inside = top * top - r * r * (1.0 - ray.mu * ray.mu);
    if (ray.mu >= 0.0 || inside <= 0.0) return false;
    const double t = (ray.altitude_m - shell.top_m) * (r + top) / (std::sqrt(inside) - r * ray.mu);
    ray.altitude_m = shell.top_m;
    ray.mu_s = (r * ray.mu_s + ray.nu * t) / top;
    ray.mu = -std::sqrt(inside) / top;
    return true;
}

}  // namespace airlight
