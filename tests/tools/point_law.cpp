#include "tools/point_law.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>

namespace airlight::test {

namespace {

constexpr double rounding = 0x1p-24;

// The change of the exact result when one argument moves by a rounding, to the worse side. The step is a few
// roundings wide, so that an answer of yes or no that the roundings of a formula may turn counts as near.
double sensitivity(const PointLaw& law, const Row& row, double exact) {
    double sum = 0.0;
    for (std::size_t i = 0; i < row.size(); ++i) {
        double worst = 0.0;
        for (const double steps : {-law.roundings, law.roundings}) {
            Row moved = row;
            moved[i] *= 1.0 + steps * rounding;
            const double change = std::abs(law.f64(moved) - exact) / law.roundings;
            if (std::isfinite(change)) worst = std::max(worst, change);
        }
        sum += worst;
    }
    return sum;
}

std::int64_t order(float x) {
    const auto bits = std::bit_cast<std::int32_t>(x);
    return bits < 0 ? -static_cast<std::int64_t>(bits & 0x7fffffff) : bits;
}

}  // namespace

Loss measure(const PointLaw& law) {
    Loss loss;
    for (const Row& row : law.rows) {
        const double exact = law.f64(row);
        const double error = std::abs(law.f32(row) - exact);
        if (error == 0.0) continue;
        loss.absolute = std::max(loss.absolute, error);
        if (exact != 0.0) loss.relative = std::max(loss.relative, error / std::abs(exact));
        // The smallest normal float: what lies below it is nothing.
        const double unit = rounding * std::abs(exact) + sensitivity(law, row, exact) + 0x1p-126;
        const double roundings = std::isnan(error) ? INFINITY : error / unit;
        if (roundings <= loss.roundings) continue;
        loss.roundings = roundings;
        loss.worst = row;
    }
    return loss;
}

long ulps_between(float a, float b) {
    if (std::isnan(a) && std::isnan(b)) return 0;
    if (std::isnan(a) || std::isnan(b)) return std::int64_t{1} << 32;
    return std::abs(order(a) - order(b));
}

}  // namespace airlight::test
