#include "sky/view_ray.h"

#include <algorithm>
#include <cmath>

#include "sky/sky.h"

namespace airlight {

std::optional<Ray> ray_of(const Shell& shell, const View& view, double distance_m) {
    Ray ray{view.altitude.value, std::cos(view.view_zenith), std::cos(view.sun_zenith), view_sun_cosine(view), distance_m};
    if (!enter_air(shell, ray)) return std::nullopt;
    if (view.altitude.value > shell.top_m) {
        // The way to the air is empty.
        const double r = shell.bottom_m + view.altitude.value, top = shell.bottom_m + shell.top_m;
        ray.limit_m -= -r * std::cos(view.view_zenith) + top * ray.mu;
    }
    if (!(ray.limit_m > 0.0)) return std::nullopt;
    return ray;
}

}  // namespace airlight
