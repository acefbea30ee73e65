// O'Neil's scale functions of the two constituents of an atmosphere, a CSV file that `airlight fit oneil2005` writes: [ONeil2005]
//     bottom_radius_m = 6360000
//     constituent,scale_height_m,c0,c1,c2,c3,c4
// with a row of air and one of aerosol. Column from the ground to the top = scale height exp(c0 + c1 x + c2 x^2 + c3 x^3 + c4 x^4),
// x = 1 - cos theta. A program's own published constants, for one planet and one height, are such a file with two equal rows.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/result.h"

namespace airlight {

struct ONeilScale {
    double scale_height_m;
    std::array<double, 5> coefficients;
};

struct ONeil2005Data {
    double bottom_radius_m;
    ONeilScale air, aerosol;
};

// Fails, naming the line, if a cell is damaged or out of range, or a row is missing.
Result<ONeil2005Data> parse_oneil2005(std::string_view text, std::string_view where);

// The text that reads back to the same numbers; `comment` becomes its first lines.
std::string oneil2005_csv(const ONeil2005Data& data, std::string_view comment);

}  // namespace airlight
