// What a reader sees of a model: pictures in the layout of the survey [Lopes2015, figures 19 to 40], maps of its error, and
// profiles of its radiance in the sun's plane. All from the sky's dome; drawn.h makes them part of a page.
// Uses the sky, its pictures and colours.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "eval/condition.h"
#include "image/image.h"
#include "sky/sky_image.h"

namespace airlight {

// One picture of the survey's layout: a day at 45 degrees north when day and night are equal.
struct PictureView {
    std::string_view title;
    double sun_zenith, sun_azimuth;  // radians
    bool towards_sun;                // a camera's view with the sun's disk; else the whole sky
};
// The sky at sunrise, noon and sunset; the sun at sunset and at 16 h.
std::array<PictureView, 5> picture_views();

struct PictureTools {
    const ColourWeights& weights;
    const RgbConverter& converter;
};

// Linear light in sRGB's primaries, `size` pixels wide. Fails if the model does not answer.
Result<Image> picture(const Sky& sky, const Sun& sun, const PictureView& view, Length altitude, int size, const PictureTools& tools);

// The exposure that shows such a picture well; the same for all models, so that brightness can be compared. 1 for black ones.
double picture_exposure(const Image& image, const RgbConverter& converter);

// Directions of a map's pixels, row by row: the sky as a fisheye with the sun upward, or, from space, the limb, from 5 degrees
// below the horizon to the top of the air, and from the sun's azimuth to the one opposite. None outside of the circle.
struct MapGrid {
    int width, height;
    std::vector<std::optional<Direction>> directions;
};
MapGrid map_grid(const Atmosphere& atmosphere, const Condition& condition, int size);

// Directions in the sun's plane: from the horizon opposite the sun over the zenith to the horizon below the sun; from space
// across the limb on the sun's side. `at` is where they stand in a plot, in degrees: from the zenith, or above the horizon.
struct ProfileGrid {
    std::string_view axis;
    std::vector<double> at;
    std::vector<Direction> directions;
};
ProfileGrid profile_grid(const Atmosphere& atmosphere, const Condition& condition);

// Luminance in each direction, cd m-2; 0 where the model does not answer. All cores.
std::vector<double> luminances(const SkyDome& dome, std::size_t wavelengths, std::span<const Direction> directions,
                               const ColourWeights& weights);

}  // namespace airlight
