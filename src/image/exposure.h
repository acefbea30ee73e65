// How much light makes white: the factor from luminance to what a tone curve takes.
// Theory: docs/theory.md, section 9.
// Uses core; knows nothing of tone curves and files.
#pragma once

#include <span>

#include "core/result.h"

namespace airlight {

// Every function returns an exposure: 1 over the luminance, in cd m-2, that becomes 1 before the tone curve. Above 0.

// `white` is the luminance that becomes 1, above 0.
double exposure_of_white(double white);

// Of a camera set to an exposure value at ISO 100: its sensor saturates at 1.2 2^EV cd m-2 (ISO 12232, with the lens
// factor q = 0.65: 78 / (100 q)). A sunny scene is near EV 15.
double exposure_of_ev100(double ev100);
double ev100_of_exposure(double exposure);

// What a light meter looks at.
struct Metering {
    enum class Method {
        log_average,  // the geometric mean of luminance becomes `grey` [Reinhard2002, eq. 1 and 2]
        percentile,   // the luminance that `share` of the light-giving image lies below becomes 1
    };
    Method method = Method::log_average;
    double grey = 0.18;
    double share = 0.99;
    // The sun's disk is left out: luminance from here on, in cd m-2. Clear skies stay below 1e5 save around the sun; the
    // disk has 1.6e9 overhead and is dimmer than this only when it can be looked at.
    double sun_disk = 1e7;
    // What is metered counts as at least this, in cd m-2: below it eyes see by their rods alone, and a night without moon stays dark.
    double darkest = 1e-3;
};

// The exposure for an image, from the luminance of each pixel in cd m-2 and, if not empty, each pixel's weight (its
// solid angle). Black pixels, and those outside of a fisheye's circle, are left out.
// Fails if nothing is left, or if a luminance is NaN or negative.
Result<double> metered_exposure(std::span<const float> luminance, std::span<const float> weight, const Metering& metering);

}  // namespace airlight
