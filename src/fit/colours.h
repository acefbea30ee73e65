// What fits of colour are made to: luminance and chromaticity of radiances at the standard wavelengths.
// Uses spectrum.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "spectrum/colour_weights.h"

namespace airlight {

// The quantities of a colour, in the order that files have them.
inline constexpr std::size_t colour_quantities = 3;  // luminance in cd m-2, x, y

// [quantity][view] of radiances [view * N + wavelength]. Black has no chromaticity; its x and y are zero.
inline std::array<std::vector<double>, colour_quantities> colours_of(std::span<const double> radiances, const ColourWeights& weights,
                                                                     std::size_t wavelengths) {
    std::array<std::vector<double>, colour_quantities> colours;
    for (std::size_t first = 0; first < radiances.size(); first += wavelengths) {
        const Xyz colour = weights.to_xyz(radiances.subspan(first, wavelengths));
        const double sum = colour.x + colour.y + colour.z;
        colours[0].push_back(colour.y);
        colours[1].push_back(sum > 0.0 ? colour.x / sum : 0.0);
        colours[2].push_back(sum > 0.0 ? colour.y / sum : 0.0);
    }
    return colours;
}

}  // namespace airlight
