// How different two colours look: CIELAB, and the CIE's colour difference of 2000.
// Equations: [SharmaWuDalal2005, eq. 2 to 22], whose test pairs are the laws. Uses spectrum/cie.h.
#pragma once

#include "spectrum/cie.h"

namespace airlight {

// CIELAB: lightness 0 to 100 (white), red against green, yellow against blue.
struct Lab {
    double l, a, b;
};

// `white` is what looks white, each part above 0.
Lab lab(Xyz colour, Xyz white);

// About 1 is just seen side by side. Symmetric, 0 for equal colours; the parametric factors are 1.
double ciede2000(Lab one, Lab other);

}  // namespace airlight
