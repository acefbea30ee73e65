#include "tools/domain.h"

#include <algorithm>
#include <array>

namespace airlight::test {

namespace {

constexpr std::array<double, 6> bottoms = {100e3, 1000e3, 3389.5e3, 6360e3, 6371e3, 70000e3};
constexpr std::array<double, 6> tops = {1e3, 60e3, 100e3, 400e3, 10000e3, 100000e3};

std::vector<double> heights(double top) {
    std::vector<double> all = {0.0, 1e-3, 2.0, 100.0};
    for (const double fraction : {1e-6, 1e-4, 0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 0.9999, 1.0 - 1e-6, 1.0}) all.push_back(fraction * top);
    std::erase_if(all, [&](double h) { return h > top; });
    return all;
}

std::vector<double> directions(double h, double bottom) {
    std::vector<double> all = cosines();
    const double horizon = f64::horizon_cosine(f64::Length::of(h), f64::Length::of(bottom)).value;
    for (double off = 1e-8; off < 1.0; off *= 10.0) {
        all.push_back(horizon * (1.0 - off));
        all.push_back(std::max(-1.0, horizon * (1.0 + off)));
    }
    return all;
}

bool down(const ShellRay& r) { return f64::meets_ground(f64::Length::of(r.h), f64::Number::of(r.mu), f64::Length::of(r.bottom)); }

}  // namespace

double to_float(double value) { return static_cast<double>(static_cast<float>(value)); }

std::vector<double> cosines() {
    std::vector<double> all = {-1.0, 0.0, 1.0};
    for (double c = -0.95; c < 1.0; c += 0.1) all.push_back(to_float(c));
    for (double off = 1e-7; off < 0.05; off *= 10.0)
        for (const double c : {-1.0 + off, -off, off, 1.0 - off}) all.push_back(to_float(c));
    return all;
}

std::vector<ShellRay> all_rays() {
    std::vector<ShellRay> all;
    for (const double bottom : bottoms)
        for (const double top : tops)
            for (const double h : heights(top))
                for (const double mu : directions(to_float(h), to_float(bottom)))
                    all.push_back({to_float(h), to_float(mu), to_float(bottom), to_float(top)});
    return all;
}

std::vector<ShellRay> rays_to_the_top() {
    std::vector<ShellRay> all = all_rays();
    std::erase_if(all, down);
    return all;
}

std::vector<ShellRay> rays_to_the_ground() {
    std::vector<ShellRay> all = all_rays();
    std::erase_if(all, [](const ShellRay& r) { return !down(r); });
    return all;
}

std::vector<double> distances_along(const ShellRay& r) {
    using namespace f64;
    const airlight::f64::Length h = Length::of(r.h), bottom = Length::of(r.bottom), top = Length::of(r.top);
    const airlight::f64::Number mu = airlight::f64::Number::of(r.mu);
    const double end = (down(r) ? distance_to_ground(h, mu, bottom) : distance_to_top(h, mu, bottom, top)).value;
    const double perigee = -(r.bottom + r.h) * r.mu;
    std::vector<double> all;
    for (const double t : {0.0, 1e-6 * end, 0.01 * end, 0.3 * end, 0.9 * end, 0.999 * end, end, perigee, 2.0 * perigee})
        if (t >= 0.0 && t <= end) all.push_back(to_float(t));
    return all;
}

std::vector<Row> combinations(const std::vector<std::vector<double>>& lists) {
    std::vector<Row> all = {{}};
    for (const std::vector<double>& list : lists) {
        std::vector<Row> longer;
        for (const Row& row : all)
            for (const double x : list) {
                longer.push_back(row);
                longer.back().push_back(to_float(x));
            }
        all = std::move(longer);
    }
    return all;
}

}  // namespace airlight::test
