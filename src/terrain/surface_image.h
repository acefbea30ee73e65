// The colours of a planet's ground from an image that GDAL reads.
// Uses core; includes GDAL in its source only.
#pragma once

#include <filesystem>

#include "core/result.h"
#include "terrain/tile.h"

namespace airlight {

// Reflectances of red, green and blue from an image of three or more bands of 8 bits in sRGB, or one of greys: of the whole planet, from 180
// degrees west to 180 degrees east and pole to pole; linear between pixels' centres. It is held in memory, 12 bytes a pixel.
// Fails, naming the path, if the file is missing, is no image, is damaged, is not twice as wide as high, or has more than 2^27 pixels.
Result<GroundColour> surface_image(const std::filesystem::path& path);

}  // namespace airlight
