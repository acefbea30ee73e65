#include "transport/density_table.h"

#include <algorithm>
#include <cassert>

namespace airlight {

DensityTable::DensityTable(std::span<const DensityProfile> profiles, Length top)
    : parts_(static_cast<int>(profiles.size())), inverse_top_(static_cast<float>(1.0 / top.value)) {
    assert(profiles.size() >= 1 && profiles.size() <= max_parts);
    for (const DensityProfile& profile : profiles)
        for (const Length altitude : jumps(profile))
            if (altitude > 0.0 * m && altitude < top) jumps_m_.push_back(altitude.value);
    std::sort(jumps_m_.begin(), jumps_m_.end());
    jumps_m_.erase(std::unique(jumps_m_.begin(), jumps_m_.end()), jumps_m_.end());
    for (int i = 0; i <= steps; ++i) {
        const double x = static_cast<double>(i) / steps;
        for (const DensityProfile& profile : profiles) values_.push_back(static_cast<float>(relative_density(profile, x * x * top)));
    }
}

}  // namespace airlight
