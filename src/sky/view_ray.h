// The part of a view that is within the air.
// Uses transport (views and rays).
#pragma once

#include <optional>

#include "transport/ray_nodes.h"
#include "transport/reference.h"

namespace airlight {

// The ray of a view within the air, over a distance from the eye; none if nothing of it is. An eye in space looks through empty
// space first, which the ray's limit does not count.
std::optional<Ray> ray_of(const Shell& shell, const View& view, double distance_m = 1e300);

}  // namespace airlight
