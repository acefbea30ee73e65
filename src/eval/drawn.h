// Pictures, maps and plots as pieces of a page that needs no other file: data URIs and SVG.
// Uses images; knows nothing of skies.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "image/image.h"

namespace airlight {

std::string base64(std::string_view bytes);

// Linear light, exposed, through the filmic curve, as "data:image/png;base64,...".
Result<std::string> picture_uri(const Image& linear, double exposure);

// The colour of a relative deviation: blue is too dark, red too bright, white right; full at 50 % either way.
struct MapColour {
    double r, g, b;  // encoded, 0 to 1
};
MapColour deviation_colour(double deviation);
// "#rrggbb".
std::string hex(MapColour colour);

// A map of deviations, row by row: grey where there is none.
Result<std::string> map_uri(int width, int height, std::span<const std::optional<double>> deviations);

// Deviations in directions of the sky, as dots of an SVG that looks like such a map; the sun's azimuth upward.
struct SkyDot {
    double zenith, azimuth;  // radians
    std::optional<double> deviation;
};
std::string dots_svg(std::span<const SkyDot> dots, int size);

// A line plot with a logarithmic height: the truth thick, the model thin. Values of 0 are gaps.
struct ProfilePlot {
    std::string_view axis;          // what `at` is
    std::span<const double> at;     // increasing
    std::span<const double> truth;  // cd m-2
    std::span<const double> model;
};
std::string profile_svg(const ProfilePlot& plot);

// Text as part of a page: the five characters that HTML takes for its own are escaped.
std::string html_text(std::string_view text);

}  // namespace airlight
