#include "image/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace airlight {

Image::Image(int w, int h, int c) : width(w), height(h), channels(c) {
    assert(check_size(w, h, c));
    values.resize(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * static_cast<std::size_t>(c));
}

Result<Done> Image::check_size(int width, int height, int channels) {
    if (width < 1 || height < 1 || width > max_side || height > max_side)
        return Error{"", fmt::format("an image of {} x {} pixels is out of range: each side has 1 to {}", width, height, max_side), ""};
    if (channels < 1 || channels > max_channels)
        return Error{"", fmt::format("an image of {} channels is out of range: it has 1 to {}", channels, max_channels), ""};
    if (static_cast<std::size_t>(width) * static_cast<std::size_t>(height) > max_values / static_cast<std::size_t>(channels))
        return Error{"", fmt::format("an image of {} x {} pixels with {} channels is too large", width, height, channels),
                     fmt::format("Keep width x height x channels to at most {}.", max_values)};
    return Done{};
}

std::span<float> Image::pixel(int column, int row) {
    assert(column >= 0 && column < width && row >= 0 && row < height);
    const std::size_t index = static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
    return {values.data() + index * static_cast<std::size_t>(channels), static_cast<std::size_t>(channels)};
}

std::span<const float> Image::pixel(int column, int row) const { return const_cast<Image*>(this)->pixel(column, row); }

void add_share(Image& sum, const Image& more, float share) {
    assert(sum.width == more.width && sum.height == more.height && sum.channels == more.channels);
    std::transform(sum.values.begin(), sum.values.end(), more.values.begin(), sum.values.begin(),
                   [share](float a, float b) { return a + share * b; });
}

Result<Done> check_values(const Image& image, std::span<const std::string> channel_names, float lowest, float highest,
                          std::string_view rule) {
    assert(channel_names.size() == static_cast<std::size_t>(image.channels));
    const auto wrong = std::find_if(image.values.begin(), image.values.end(), [&](float v) { return !(v >= lowest && v <= highest); });
    if (wrong == image.values.end()) return Done{};
    const auto index = static_cast<std::size_t>(wrong - image.values.begin());
    const auto channels = static_cast<std::size_t>(image.channels), width = static_cast<std::size_t>(image.width);
    return Error{"",
                 fmt::format("pixel ({}, {}), channel {}, is {}: {}", index / channels % width, index / channels / width,
                             channel_names[index % channels], *wrong, rule),
                 "Nothing was written; the light at this pixel was computed wrongly."};
}

}  // namespace airlight
