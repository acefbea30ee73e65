// The coefficients of Hipiny's sky by altitude, a CSV file that `airlight fit hipiny2006` writes:
//     altitude_m,turbidity,sun_zenith_deg,quantity,a,b,c,d,e,zenith
// quantity Y (cd m-2), x or y: value = zenith * F(view, gamma) / F(zenith, sun zenith) with Perez's F (physics/models/perez.glsl)
// of the row's coefficients; b is at most 0. Every combination once, in any order; five altitudes in the thesis, 0 to 30 km.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "physics/models/f64.h"

namespace airlight {

// Perez's coefficients, and the value straight up.
struct Hipiny2006Fit {
    double a, b, c, d, e, zenith;
    friend bool operator==(const Hipiny2006Fit&, const Hipiny2006Fit&) = default;
};

// Of luminance and chromaticity.
struct Hipiny2006Patch {
    Hipiny2006Fit luminance, x, y;
    friend bool operator==(const Hipiny2006Patch&, const Hipiny2006Patch&) = default;
};

struct Hipiny2006Data {
    std::vector<double> altitudes_m;  // each of the three increases
    std::vector<double> turbidities;
    std::vector<double> sun_zeniths_deg;
    std::vector<Hipiny2006Patch> patches;  // [altitude][turbidity][sun]

    std::size_t index(std::size_t altitude, std::size_t turbidity, std::size_t sun) const {
        return (altitude * turbidities.size() + turbidity) * sun_zeniths_deg.size() + sun;
    }
};

// Fails, naming the line, if a cell is damaged, out of range or there twice, or a combination is missing.
Result<Hipiny2006Data> parse_hipiny2006(std::string_view text, std::string_view where);

// The text that reads back to the same numbers; `comment` becomes its first lines.
std::string hipiny2006_csv(const Hipiny2006Data& data, std::string_view comment);

// The colour at one of the altitudes and turbidities, between two suns, towards a zenith angle of cosine mu >= 0, at an angle of cosine
// nu from the sun.
f64::ColourYxy hipiny2006_colour(const Hipiny2006Data& data, std::size_t altitude, std::size_t turbidity, double sun_zenith, double mu,
                                 double nu);

// The fit of a patch in the text's form, for a sun.
f64::Preetham1999 in_text(const Hipiny2006Patch& patch, double sun_zenith);

}  // namespace airlight
