// Eclipses of the sun by a body before it: how much of its disk's light is left. docs/theory.md, section 7.1.
// Uses core; where the bodies stand is said by sun/position.h.
#pragma once

namespace airlight {

// The area that two disks of radii a and b have in common, whose centres are a distance d apart; all >= 0.
double disks_in_common(double a, double b, double d);

// What a moon covers of the light of a disk as bright as the sun's middle: of a uniform disk, and what the two coefficients of limb
// darkening add to that.
struct CoveredSun {
    double disk, first, second;
};

//   separation   between the centres of the disks, in radians, >= 0
//   sun, moon    their radii, in radians, sun > 0, moon >= 0
// Exact for a uniform disk; a darkened one is a pile of uniform ones, of which 24 are within 0.01 % of the sun's light of all.
CoveredSun covered_sun(double separation, double sun, double moon);

// The part of the sun's light that is left, 0 to 1, with limb darkening I(mu) / I(1) = 1 - dark_1 (1 - mu) - dark_2 (1 - mu)^2.
double sunlight_left(const CoveredSun& covered, double dark_1, double dark_2);

}  // namespace airlight
