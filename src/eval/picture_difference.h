// How different two pictures for the screen look: the colour difference of the CIE between what an eye makes of each pixel.
// Uses ciede2000.h and images of PNG files.
#pragma once

#include "core/result.h"
#include "image/image.h"
#include "image/png.h"

namespace airlight {

// Of CIEDE2000: 1 is just seen where two colours meet. `mean` over all pixels; `high`: 99 of 100 pixels have no more.
struct PictureDifference {
    double mean, high;
    Image pixels;  // of one channel
};

// Both are light of sRGB first, blurred a little, by (1, 2, 1) / 4 each way: at 60 pixels a degree an eye sees neither dither nor the
// exact stair of an edge [AnderssonEtAl2020]. Symmetric, 0 for equal pictures. Fails, naming the sizes, if they differ, or if a picture is not
// one of three channels of 8 bits.
Result<PictureDifference> picture_difference(const PngLevels& one, const PngLevels& other);

}  // namespace airlight
