// The solar position that Preetham, Shirley and Smits print with their sky [Preetham1999, appendix A.6], beside ours.
// docs/theory.md, section 7. For comparison only: sun/position.h is right to 0.0005 deg.
#pragma once

#include "sun/position.h"

namespace airlight {

// The published zenith angle; the published azimuth with its slip mended, see below. Within 1 deg of sun_position()
// in this century, with the same conventions.
//
// The paper's terms: the standard meridian is Greenwich here, so its time of day is UTC; its longitudes count westward,
// for only so does "+ 12 (SM - L) / pi" move noon later to the west. Its azimuth counts from south, westward, and reads
//     atan2(-cos d sin(pi t/12),   cos l sin d - sin l cos d cos(pi t/12));
// but the southward part of the sun's direction is -cos l sin d - sin l cos d cos(pi t/12): as printed, the square of
// both parts is not the square of the sine of the zenith angle, and a sun north of the zenith at noon is put south.
HorizontalDirection preetham1999_sun(const Place& place, const Utc& moment);

}  // namespace airlight
