// What shaders know of colour comes from spectrum/colour.h.
// Uses spectrum.
#pragma once

#include <array>

namespace airlight::render {

// Of red, green and blue of linear sRGB: the share that each has in luminance; then 0.
std::array<float, 4> luminance_of_rgb();

}  // namespace airlight::render
