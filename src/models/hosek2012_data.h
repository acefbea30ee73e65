// The coefficients of Hosek and Wilkie's sky: control points by wavelength, albedo of the ground and turbidity.
// [HosekWilkie2012; HosekWilkie2013]. The published set and fits of `airlight fit hosek` have the same form, a CSV file:
//     wavelength_nm,ground_albedo,turbidity,coefficient,p0,p1,p2,p3,p4,p5
// before which may stand "altitude_m = 20000", the altitude of the eye that it is for (else the ground);
// with coefficients A to I and "radiance" (W m-2 sr-1 nm-1), and every combination once, in any order.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace airlight {

inline constexpr std::string_view hosek2012_coefficients[] = {"A", "B", "C", "D", "E", "F", "G", "H", "I", "radiance"};

// Six control points of each coefficient, in the order of hosek2012_coefficients.
using Hosek2012Points = std::array<std::array<double, 6>, 10>;

struct Hosek2012Data {
    std::vector<double> wavelengths_nm;  // each of the three increases
    std::vector<double> albedos;
    std::vector<double> turbidities;
    std::vector<Hosek2012Points> points;  // [wavelength][albedo][turbidity]
    double altitude_m = 0.0;              // of the eye

    std::size_t index(std::size_t wavelength, std::size_t albedo, std::size_t turbidity) const {
        return (wavelength * albedos.size() + albedo) * turbidities.size() + turbidity;
    }

    // Between albedos and turbidities, each within its own range. An axis of one value is no axis: its value holds for all.
    Hosek2012Points between(std::size_t wavelength, double albedo, double turbidity) const;
};

// Fails, naming the line, if a cell is damaged, out of range or there twice, or a combination is missing.
Result<Hosek2012Data> parse_hosek2012(std::string_view text, std::string_view where);

// The text that reads back to the same numbers; `comment` becomes its first lines.
std::string hosek2012_csv(const Hosek2012Data& data, std::string_view comment);

}  // namespace airlight
