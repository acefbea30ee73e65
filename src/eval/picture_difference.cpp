#include "eval/picture_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/parallel.h"
#include "eval/ciede2000.h"
#include "spectrum/colour.h"

namespace airlight {

namespace {

constexpr double share = 0.99;

Image light_of(const PngLevels& picture) {
    Image light(picture.width, picture.height, 3);
    for (std::size_t i = 0; i < picture.levels.size(); ++i) light.values[i] = static_cast<float>(srgb_linear(picture.levels[i] / 255.0));
    return light;
}

// Beyond an edge the picture goes on as at the edge.
Rgb blurred(const Image& light, int column, int row) {
    constexpr double weights[] = {0.25, 0.5, 0.25};
    Rgb sum{0.0, 0.0, 0.0};
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
            const std::span<const float> rgb =
                light.pixel(std::clamp(column + i, 0, light.width - 1), std::clamp(row + j, 0, light.height - 1));
            const double weight = weights[i + 1] * weights[j + 1];
            sum.r += weight * static_cast<double>(rgb[0]);
            sum.g += weight * static_cast<double>(rgb[1]);
            sum.b += weight * static_cast<double>(rgb[2]);
        }
    return sum;
}

Result<Done> check_kind(const PngLevels& picture) {
    if (picture.channels == 3 && picture.bits == 8) return Done{};
    return Error{"", fmt::format("a picture has {} channels of {} bits; it must have three of 8", picture.channels, picture.bits), ""};
}

}  // namespace

Result<PictureDifference> picture_difference(const PngLevels& one, const PngLevels& other) {
    for (const PngLevels* picture : {&one, &other})
        if (const Result<Done> kind = check_kind(*picture); !kind) return kind.error();
    if (one.width != other.width || one.height != other.height)
        return Error{"", fmt::format("a picture has {} x {} pixels, the other {} x {}", one.width, one.height, other.width, other.height),
                     ""};
    const RgbConverter converter(RgbSpace::srgb, WhitePoint::d65);
    const Xyz white = converter.to_xyz({1.0, 1.0, 1.0});
    const Image first = light_of(one), second = light_of(other);
    PictureDifference difference{0.0, 0.0, Image(one.width, one.height, 1)};
    parallel_for(static_cast<std::size_t>(one.height), [&](std::size_t at) {
        const int row = static_cast<int>(at);
        for (int column = 0; column < one.width; ++column)
            difference.pixels.pixel(column, row)[0] = static_cast<float>(ciede2000(
                lab(converter.to_xyz(blurred(first, column, row)), white), lab(converter.to_xyz(blurred(second, column, row)), white)));
    });
    std::vector<float> sorted = difference.pixels.values;
    std::sort(sorted.begin(), sorted.end());
    double sum = 0.0;
    for (const float value : sorted) sum += static_cast<double>(value);
    difference.mean = sum / static_cast<double>(sorted.size());
    const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
    difference.high = static_cast<double>(sorted[rank - 1]);
    return difference;
}

}  // namespace airlight
