// A picture of the sky: each pixel's light, in the linear colours of a display's or a file's primaries.
// Uses the sky, projections and colour; knows nothing of exposure and files.
#pragma once

#include "image/image.h"
#include "image/projection.h"
#include "sky/sky.h"
#include "spectrum/colour.h"
#include "spectrum/colour_weights.h"

namespace airlight {

// What is looked at, and from where.
struct SkyScene {
    Length altitude = 0.0 * m;  // of the eye
    double sun_zenith = 0.0;    // radians, 0 to pi
    double sun_azimuth = 0.0;   // radians from north, clockwise
    double sunlight = 1.0;      // irradiance of the sun relative to the atmosphere's own: 1 / distance_au^2
    bool sun_disk = true;       // whether the disk itself is drawn, averaged over each pixel that it touches
};

// Three channels, in cd m-2 of the primaries; colours out of their triangle are brought to its edge (RgbConverter::into_gamut).
// Pixels that see nothing (outside a fisheye's circle) are black. All cores; `progress` may stop it.
// Fails if the sky cannot answer for this eye and sun.
Result<Image> sky_image(const Sky& sky, const Sun& sun, const SkyScene& scene, const Projection& projection, const ColourWeights& weights,
                        const RgbConverter& converter, const Progress& progress = {});

}  // namespace airlight
