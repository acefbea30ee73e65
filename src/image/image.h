// Pixels in memory: rows of floats.
// What the numbers mean (cd m-2, W m-2 sr-1 nm-1, display values) is said by who makes and who writes them.
// Uses core.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/result.h"

namespace airlight {

// width x height pixels of `channels` floats each; `values` has shape [height][width][channels], top row first, left
// column first. Bounds: 1 <= width, height <= 65536, 1 <= channels <= 4096, and at most 2^30 values (4 GiB).
struct Image {
    static constexpr int max_side = 65536;
    static constexpr int max_channels = 4096;
    static constexpr std::size_t max_values = std::size_t{1} << 30;

    // All zero. The size must be within bounds: ask check_size() of sizes that a user or a file gives.
    Image(int width, int height, int channels);

    // Fails, naming the size, if an image of it would be out of bounds.
    static Result<Done> check_size(int width, int height, int channels);

    std::span<float> pixel(int column, int row);
    std::span<const float> pixel(int column, int row) const;

    int width, height, channels;
    std::vector<float> values;
};

// Adds a share of another image of the same shape: the mean of several is the sum of their equal shares.
void add_share(Image& sum, const Image& more, float share);

// Fails, naming the first pixel and its channel, if a value is not within [lowest, highest]; NaN never is.
// `channel_names` has one name a channel; `rule` says what values are, such as "radiance is finite and not negative".
Result<Done> check_values(const Image& image, std::span<const std::string> channel_names, float lowest, float highest,
                          std::string_view rule);

}  // namespace airlight
