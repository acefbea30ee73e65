// Absorption of light by ozone and nitrogen dioxide.
// Theory: docs/theory.md, section 3.2. Uses curves; knows nothing of how much of a gas there is.
#pragma once

#include "units/curve.h"
#include "units/units.h"

namespace airlight {

// Absorption cross-section of a molecule from 300 to 830 nm, means over bands of 5 nm; linear in temperature between the
// measured ones, and that of the coldest or warmest beyond: 203 to 293 K for ozone, 223 to 293 K for nitrogen dioxide.
// Nitrogen dioxide was measured to 760 nm, where it hardly absorbs, and is zero beyond.
// Source: data/ozone_cross_section.source.md and data/nitrogen_dioxide_cross_section.source.md; [Bogumil2003].
SpectrumOf<Area> ozone_cross_section(double temperature_k);
SpectrumOf<Area> nitrogen_dioxide_cross_section(double temperature_k);

}  // namespace airlight
