// The colours of a planet's ground, from an image that GDAL reads.
// Uses core; includes GDAL in its source only.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "core/result.h"

namespace airlight {

// Of the whole planet, from 180 degrees west to 180 degrees east and pole to pole.
struct SurfaceImage {
    int width, height;
    std::vector<std::uint8_t> levels;  // red, green, blue and 255 of each pixel in sRGB, from the north-western corner, row by row
};

// What colours the ground: an image or, where there is none, what covers it (terrain/ground_cover.h).
struct GroundColour {
    std::shared_ptr<const SurfaceImage> image = nullptr;
};

// An image of three or more bands of 8 bits in sRGB, or one of greys; it is held in memory, 4 bytes a pixel.
// Fails, naming the path, if the file is missing, is no image, is damaged, has a palette, is not twice as wide as high, or
// has more than 2^27 pixels.
Result<GroundColour> surface_image(const std::filesystem::path& path);

}  // namespace airlight
