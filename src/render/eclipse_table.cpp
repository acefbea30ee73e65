#include "render/eclipse_table.h"

#include <algorithm>
#include <cmath>

#include "celestial/eclipse.h"

namespace airlight::render {

EclipseTable eclipse_table(const Eclipse& eclipse, Vec3 centre_m, double reach_m) {
    const double distance_m = glm::length(eclipse.moon_m - centre_m), size = eclipse.moon_radius_m / eclipse.sun_radius;
    const double low = size / (distance_m + reach_m), high = size / std::max(distance_m - reach_m, 0.5 * distance_m);
    EclipseTable table{static_cast<float>(low), static_cast<float>(high), {}};
    for (int row = 0; row < EclipseTable::rows; ++row) {
        const double ratio = low + (high - low) * row / (EclipseTable::rows - 1);
        const double inner = std::abs(ratio - 1.0), outer = ratio + 1.0;
        for (int column = 0; column < EclipseTable::columns; ++column) {
            const double u = static_cast<double>(column) / (EclipseTable::columns - 1), beyond = std::max(u - 0.25, 0.0) / 0.75;
            const double separation = u < 0.25 ? 4.0 * u * inner : inner + beyond * beyond * (outer - inner);
            const CoveredSun covered = covered_sun(separation, 1.0, ratio);
            for (const double value : {covered.disk, covered.first, covered.second, 0.0}) table.texels.push_back(static_cast<float>(value));
        }
    }
    return table;
}

}  // namespace airlight::render
