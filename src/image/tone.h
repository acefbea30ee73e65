// From linear light to a display's range: curves that bend what is too bright, and images through them.
// Theory: docs/theory.md, section 9.
// Uses images; exposure.h makes the factor.
#pragma once

#include <optional>
#include <string_view>

#include "image/image.h"

namespace airlight {

// Each curve rises strictly from 0 at 0 towards 1 at infinity (linear: to 1 at 1, and stays).
enum class ToneCurve {
    linear,       // x, cut at 1: for comparisons
    exponential,  // 1 - e^-x: what atmospheric scattering was first shown with [Nielsen2003; Sperlhofer2011, eq. 4-19]
    reinhard,     // x / (1 + x) [Reinhard2002, eq. 3]
    filmic,       // Hable's curve, with toe and shoulder, scaled to end at 1 and to keep 0.18 [Hable2010]
};

// "linear", "exponential", "reinhard", "filmic". None if there is no such name.
std::optional<ToneCurve> tone_curve_named(std::string_view name);
std::string_view name_of(ToneCurve curve);
inline constexpr std::string_view tone_curve_names = "linear exponential reinhard filmic";

// The display value in [0, 1] of x >= 0, exposed linear light.
double tone(ToneCurve curve, double x);

// Each value times `exposure` through the curve: linear display values in [0, 1], not yet encoded for sRGB (png.h does).
// Of channels, each on its own, as the theses do; bright colours tend to white. Values are finite and not negative.
Image developed(const Image& linear, double exposure, ToneCurve curve);

}  // namespace airlight
