// Where a wavelength lies between those of a file of coefficients. What the file says is linear between two of its wavelengths.
// Uses core and units.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "units/units.h"

namespace airlight {

struct WavelengthMix {
    std::size_t low, high;
    double weight;  // of high
};

// `data_nm` increases; `w_nm` lies within.
inline WavelengthMix mix_at(const std::vector<double>& data_nm, double w_nm) {
    const auto above = std::lower_bound(data_nm.begin(), data_nm.end(), w_nm);
    const auto high = static_cast<std::size_t>(above - data_nm.begin());
    if (*above == w_nm) return {high, high, 0.0};
    return {high - 1, high, (w_nm - data_nm[high - 1]) / (data_nm[high] - data_nm[high - 1])};
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
