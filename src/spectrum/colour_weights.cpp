#include "spectrum/colour_weights.h"

#include <algorithm>
#include <cassert>

namespace airlight {

namespace {

// Second derivatives at the knots of the natural cubic spline through (x, y), by elimination of its tridiagonal system
// h[i-1] m[i-1] + 2 (h[i-1] + h[i]) m[i] + h[i] m[i+1] = 6 (slope[i] - slope[i-1]), m = 0 at both ends.
std::vector<double> second_derivatives(std::span<const double> x, std::span<const double> y) {
    const std::size_t n = x.size();
    std::vector<double> m(n, 0.0), upper(n, 0.0);
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const double before = x[i] - x[i - 1];
        const double after = x[i + 1] - x[i];
        const double right = 6.0 * ((y[i + 1] - y[i]) / after - (y[i] - y[i - 1]) / before);
        const double pivot = 2.0 * (before + after) - before * upper[i - 1];
        upper[i] = after / pivot;
        m[i] = (right - before * m[i - 1]) / pivot;
    }
    for (std::size_t i = n - 1; i-- > 1;) m[i] -= upper[i] * m[i + 1];
    return m;
}

// The spline at `at`, held constant past its ends.
double spline(std::span<const double> x, std::span<const double> y, std::span<const double> m, double at) {
    if (at <= x.front()) return y.front();
    if (at >= x.back()) return y.back();
    const auto j = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), at) - x.begin());
    const double h = x[j] - x[j - 1];
    const double a = (x[j] - at) / h;
    const double b = (at - x[j - 1]) / h;
    return a * y[j - 1] + b * y[j] + ((a * a * a - a) * m[j - 1] + (b * b * b - b) * m[j]) * h * h / 6.0;
}

// Colour of the sun's light times the spline that is one at wavelength i of the grid and zero at all others.
Xyz colour_of_cardinal_spline(std::span<const double> wavelengths, std::size_t i, const SpectrumOf<SpectralIrradiance>& sun) {
    std::vector<double> one(wavelengths.size(), 0.0);
    one[i] = 1.0;
    const std::vector<double> m = second_derivatives(wavelengths, one);
    Xyz sum{0.0, 0.0, 0.0};
    for (const ColourMatch& row : cie1931()) {
        const double light = sun.at(row.wavelength_nm * nm).value * spline(wavelengths, one, m, row.wavelength_nm);
        sum = sum + light * Xyz{row.x, row.y, row.z};
    }
    return lumen_per_watt * cie_step_nm * sum;
}

template <class T>
Xyz weighted_sum(std::span<const Xyz> weights, std::span<const T> spectrum) {
    assert(spectrum.size() == weights.size());
    Xyz sum{0.0, 0.0, 0.0};
    for (std::size_t i = 0; i < weights.size(); ++i) sum = sum + static_cast<double>(spectrum[i]) * weights[i];
    return sum;
}

}  // namespace

ColourWeights::ColourWeights(const WavelengthGrid& grid, const SpectrumOf<SpectralIrradiance>& sun) {
    std::vector<double> wavelengths;
    for (const Wavelength w : grid) wavelengths.push_back(w.in(nm));
    for (std::size_t i = 0; i < wavelengths.size(); ++i) {
        const double irradiance = sun.at(wavelengths[i] * nm).value;
        assert(irradiance > 0.0);
        weights_.push_back(1.0 / irradiance * colour_of_cardinal_spline(wavelengths, i, sun));
    }
}

Xyz ColourWeights::to_xyz(std::span<const double> spectrum) const { return weighted_sum<double>(weights_, spectrum); }
Xyz ColourWeights::to_xyz(std::span<const float> spectrum) const { return weighted_sum<float>(weights_, spectrum); }

}  // namespace airlight
