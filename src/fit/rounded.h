// Numbers as the files of fits have them.
// Uses nothing of this project.
#pragma once

#include <fmt/format.h>

#include <charconv>

namespace airlight {

// To so many digits: what is written is what the residuals are of.
inline double rounded(double x, int digits) {
    double y = 0.0;
    const std::string text = fmt::format("{:.{}g}", x, digits);
    std::from_chars(text.data(), text.data() + text.size(), y);
    return y;
}

}  // namespace airlight
