// The light of a sky without sun and moon, between the stars that are seen. docs/theory.md, section 7.5.
// Uses colours; knows no air but the layer of it that glows.
#pragma once

#include "spectrum/cie.h"
#include "units/units.h"

namespace airlight {

// Between these altitudes the air glows: the green line of oxygen, sodium and OH shine from around 90 km [Leinert1998, sec. 6].
inline constexpr Length airglow_bottom = 85.0 * km, airglow_top = 95.0 * km;

// cd m-2 of one star of magnitude 10 in each square degree, the unit S10 of the sources.
double luminance_of_s10();

// As it is at sunspot minimum, far from the Milky Way and from the ecliptic; elsewhere it is up to three times as bright. Its colour is that
// of a dark sky as it was measured, B - V = 0.8 through the air [BennEllison1998], in all of its parts.
struct NightSky {
    Xyz beyond;   // cd m-2 from outside of the air: zodiacal light, stars fainter than magnitude 6, and dust in their light
    Xyz airglow;  // cd m-2 of the glowing layer, crossed upright
};
NightSky night_sky();

// What van Rhijn's law [vanRhijn1921] makes of a thin layer at 90 km, over what it is at the zenith of an eye on the ground:
// 1 / sqrt(1 - (r / r_layer)^2 sin^2 z) at a zenith angle z, 0 to pi / 2.
double van_rhijn(double zenith_angle);

// Of the whole sky over level ground, were there no air below: the mean over its directions, in cd m-2, and the illuminance, in lux.
// Of van Rhijn's law both have closed forms. Air sends back about as much as it takes: the illuminance stays within a tenth.
Xyz mean_luminance(const NightSky& sky);
Xyz illuminance(const NightSky& sky);

}  // namespace airlight
