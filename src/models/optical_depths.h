// The table of transmittance that several models share: optical depths to the top of the air, by bruneton2008's map.
#pragma once

#include <vector>

#include "transport/pack_tables.h"

namespace airlight {

// Texels across (directions) and down (altitudes). [BrunetonNeyret2008, section 4; Hillaire2020, table 1]
inline constexpr int depths_across = 256;
inline constexpr int depths_down = 64;

// Of rays that do not meet the ground: [down][across].
std::vector<f32::Spectrum> optical_depths(const PackAir& air);

}  // namespace airlight
