// Preetham's sky with coefficients of an atmosphere: what `airlight fit preetham` writes and preetham1999 reads. [Preetham1999, app. A.2]
// Its file is a CSV, a row for each coefficient in the order of preetham1999_coefficients:
//     lowest_turbidity = 2
//     highest_turbidity = 6
//     altitude_m = 0                  (of the eye; may be left out)
//     quantity,coefficient,t2,t1,t0
// coefficient = t2 T^2 + t1 T + t0 for the turbidity T; one turbidity alone, lowest and highest, is a fit to one atmosphere. Quantity Y
// (luminance), x or y: value = zenith * F(view, gamma) / F(zenith, sun zenith) with Perez's F of a to e, b at most 0. In the zenith
//     Y = 1000 (tangent tan(chi (pi - 2 s)) + even) cd m-2, chi from 0 to below 1/2;   x, y = ((z3 s + z2) s + z1) s + z0
// where s is the sun's zenith angle in radians.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/result.h"
#include "physics/models/f64.h"

namespace airlight {

struct PreethamCoefficient {
    std::string_view quantity, name;
};
inline constexpr PreethamCoefficient preetham1999_coefficients[] = {
    {"Y", "a"}, {"Y", "b"}, {"Y", "c"}, {"Y", "d"}, {"Y", "e"},  {"Y", "chi"}, {"Y", "tangent"}, {"Y", "even"}, {"x", "a"},
    {"x", "b"}, {"x", "c"}, {"x", "d"}, {"x", "e"}, {"x", "z3"}, {"x", "z2"},  {"x", "z1"},      {"x", "z0"},   {"y", "a"},
    {"y", "b"}, {"y", "c"}, {"y", "d"}, {"y", "e"}, {"y", "z3"}, {"y", "z2"},  {"y", "z1"},      {"y", "z0"}};

// t2, t1, t0.
using TurbidityPolynomial = std::array<double, 3>;

struct Preetham1999Data {
    double lowest_turbidity, highest_turbidity;
    double altitude_m = 0.0;  // of the eye
    std::array<TurbidityPolynomial, std::size(preetham1999_coefficients)> coefficients;
};

// What a turbidity makes of the coefficients from `first` on: five of Perez's and those of the zenith.
struct PreethamQuantity {
    f64::PerezCoefficients k;
    std::array<double, 4> zenith;  // chi, tangent, even; or z3, z2, z1, z0
};

// The value in the zenith, luminance in cd m-2.
double preetham_zenith_luminance(const PreethamQuantity& quantity, double sun_zenith);
double preetham_zenith_chromaticity(const PreethamQuantity& quantity, double sun_zenith);

// The formula in the text's form, for a turbidity and a sun.
f64::Preetham1999 in_text(const Preetham1999Data& data, double turbidity, double sun_zenith);

// Fails, naming the line, if a cell is damaged or out of range, or a row is missing or out of order.
Result<Preetham1999Data> parse_preetham1999(std::string_view text, std::string_view where);

// The text that reads back to the same numbers; `comment` becomes its first lines.
std::string preetham1999_csv(const Preetham1999Data& data, std::string_view comment);

}  // namespace airlight
