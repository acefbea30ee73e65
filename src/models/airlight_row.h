// Rays of the model `airlight` that share their way through the air: those of one eye and one view zenith angle, by azimuth.
// Uses models/airlight_tables.h.
#pragma once

#include <span>
#include <vector>

#include "models/airlight_tables.h"

namespace airlight {

// The light along each ray: [rays]. Their altitudes and view zenith angles are one, and they run to the ground or out of the air;
// at least one. Altitudes, densities and transmittances along the way are computed once, and anew only between cuts by the
// planet's shadow.
// `air`: that of the tables, or with another rule.
std::vector<f32::AirlightLight> airlight_row(const f32::AirlightAir& air, const AirlightTables& tables,
                                             std::span<const f32::AirlightRay> rays);

}  // namespace airlight
