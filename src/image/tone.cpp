#include "image/tone.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "core/parallel.h"

namespace airlight {

namespace {

constexpr std::array<std::pair<std::string_view, ToneCurve>, 4> names{{{"linear", ToneCurve::linear},
                                                                       {"exponential", ToneCurve::exponential},
                                                                       {"reinhard", ToneCurve::reinhard},
                                                                       {"filmic", ToneCurve::filmic}}};

// [Hable2010]: (x (A x + C B) + D E) / (x (A x + B) + D F) - E / F with shoulder A = 0.15, B = 0.5, linear part C = 0.1,
// D = 0.2 and toe E = 0.02, F = 0.3. Published, it is divided by its value at a white of 11.2 and cut; here by its limit
// 1 - E / F. Over a common denominator, so that small x lose no digits: x (A x (F - E) + B (C F - E)) / F over the same.
double filmic(double x) {
    constexpr double keeps_grey = 3.9453724810575306;  // the factor with which 0.18 stays 0.18
    constexpr double A = 0.15, B = 0.50, C = 0.10, D = 0.20, E = 0.02, F = 0.30;
    const double y = std::min(keeps_grey * x, 1e100);
    const double numerator = y * (A * y * (F - E) + B * (C * F - E));
    return numerator / ((y * (A * y + B) + D * F) * (F - E));
}

}  // namespace

std::optional<ToneCurve> tone_curve_named(std::string_view name) {
    for (const auto& [candidate, curve] : names)
        if (candidate == name) return curve;
    return std::nullopt;
}

std::string_view name_of(ToneCurve curve) {
    for (const auto& [name, candidate] : names)
        if (candidate == curve) return name;
    return {};
}

double tone(ToneCurve curve, double x) {
    assert(x >= 0.0);
    if (curve == ToneCurve::linear) return std::min(x, 1.0);
    if (curve == ToneCurve::exponential) return -std::expm1(-x);
    if (curve == ToneCurve::reinhard) return x / (1.0 + x);
    return filmic(x);
}

Image developed(const Image& linear, double exposure, ToneCurve curve) {
    Image result(linear.width, linear.height, linear.channels);
    const std::size_t row_size = static_cast<std::size_t>(linear.width) * static_cast<std::size_t>(linear.channels);
    parallel_for(static_cast<std::size_t>(linear.height), [&](std::size_t row) {
        for (std::size_t i = row * row_size; i < (row + 1) * row_size; ++i)
            result.values[i] = static_cast<float>(tone(curve, exposure * static_cast<double>(linear.values[i])));
    });
    return result;
}

}  // namespace airlight
