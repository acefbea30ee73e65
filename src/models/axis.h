// Where a value lies between those of an axis of a file of coefficients: what the file says is linear between two of them.
// Uses core and units.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "units/units.h"

namespace airlight {

struct AxisPlace {
    std::size_t low, high;
    double weight;  // of high; 0 where low is all that counts, which is high then as well

    // Between what f says of low and of high.
    template <class F>
    double between(F f) const {
        return low == high ? f(low) : std::lerp(f(low), f(high), weight);
    }
};

// `axis` increases. What lies beyond an end is taken for the end.
inline AxisPlace place_on(std::span<const double> axis, double x) {
    const auto above = std::lower_bound(axis.begin(), axis.end(), x);
    const auto high = static_cast<std::size_t>(above - axis.begin());
    if (high == axis.size()) return {high - 1, high - 1, 0.0};
    if (high == 0 || *above == x) return {high, high, 0.0};
    return {high - 1, high, (x - axis[high - 1]) / (axis[high] - axis[high - 1])};
}

// Fails if a wavelength lies outside of the data's.
inline Result<Done> data_covers(const std::vector<double>& data_nm, std::span<const Wavelength> wavelengths, std::string_view model) {
    for (const Wavelength w : wavelengths)
        if (!(w.in(nm) >= data_nm.front() && w.in(nm) <= data_nm.back()))
            return Error{std::string(model),
                         fmt::format("does not answer {:g} nm: its data is for {:g} to {:g} nm", w.in(nm), data_nm.front(), data_nm.back()),
                         fmt::format("Choose wavelengths within, as --wavelengths {:g}:{:g}:10.", data_nm.front(), data_nm.back())};
    return Done{};
}

}  // namespace airlight
