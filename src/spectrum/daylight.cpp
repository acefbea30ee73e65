#include "spectrum/daylight.h"

#include <algorithm>
#include <cassert>
#include <iterator>

namespace airlight {

namespace {

struct Row {
    double wavelength_nm, mean, first, second;
};
constexpr Row table[] = {
#include "daylight.inc"
};
constexpr double step_nm = 10.0;

Row row_at(double wavelength_nm) {
    const double x = (wavelength_nm - table[0].wavelength_nm) / step_nm;
    assert(x >= 0.0 && x <= static_cast<double>(std::size(table) - 1));
    const std::size_t low = std::min(static_cast<std::size_t>(x), std::size(table) - 2);
    const double t = x - static_cast<double>(low);
    const Row &a = table[low], &b = table[low + 1];
    return {wavelength_nm, a.mean + t * (b.mean - a.mean), a.first + t * (b.first - a.first), a.second + t * (b.second - a.second)};
}

}  // namespace

Daylight::Daylight(std::span<const Wavelength> wavelengths) : luminance_{0.0, 0.0, 0.0} {
    for (const Wavelength w : wavelengths) {
        const Row row = row_at(w.in(nm));
        samples_.push_back({row.mean, row.first, row.second});
    }
    for (const ColourMatch& match : cie1931()) {
        const Row row = row_at(match.wavelength_nm);
        const double weight = lumen_per_watt * match.y * cie_step_nm;
        luminance_.mean += weight * row.mean;
        luminance_.first += weight * row.first;
        luminance_.second += weight * row.second;
    }
}

// [CIE2018, section 4.1.2]
Daylight::Amounts Daylight::amounts(Chromaticity c) const {
    const double divisor = 0.0241 + 0.2562 * c.x - 0.7341 * c.y;
    const double first = (-1.3515 - 1.7703 * c.x + 5.9114 * c.y) / divisor;
    const double second = (0.0300 - 31.4424 * c.x + 30.0717 * c.y) / divisor;
    const double y = luminance_.mean + first * luminance_.first + second * luminance_.second;
    return {1.0 / y, first / y, second / y};
}

void Daylight::radiance(Chromaticity colour, double y, std::span<double> radiance) const {
    assert(radiance.size() == samples_.size());
    const Amounts a = amounts(colour);
    for (std::size_t i = 0; i < samples_.size(); ++i) {
        const Sample& s = samples_[i];
        radiance[i] = std::max(0.0, y * (a.mean * s.mean + a.first * s.first + a.second * s.second));
    }
}

void Daylight::radiance(Chromaticity colour, double y, std::span<float> radiance) const {
    assert(radiance.size() == samples_.size());
    const Amounts a = amounts(colour);
    for (std::size_t i = 0; i < samples_.size(); ++i) {
        const Sample& s = samples_[i];
        radiance[i] = static_cast<float>(std::max(0.0, y * (a.mean * s.mean + a.first * s.first + a.second * s.second)));
    }
}

}  // namespace airlight
