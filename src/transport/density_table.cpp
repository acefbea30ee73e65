#include "transport/density_table.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace airlight {

DensityTable::DensityTable(std::span<const DensityProfile> profiles, Length top)
    : profiles_(profiles.begin(), profiles.end()),
      parts_(static_cast<int>(profiles.size())),
      inverse_top_(static_cast<float>(1.0 / top.value)) {
    assert(profiles.size() >= 1 && profiles.size() <= max_parts);
    for (const DensityProfile& profile : profiles)
        for (const Length altitude : jumps(profile))
            if (altitude > 0.0 * m && altitude < top) jumps_m_.push_back(altitude.value);
    std::sort(jumps_m_.begin(), jumps_m_.end());
    jumps_m_.erase(std::unique(jumps_m_.begin(), jumps_m_.end()), jumps_m_.end());
    // A step to either side too: floats that round onto a neighbour find the same answer there.
    jump_within_.assign(steps, 0);
    for (const double altitude : jumps_m_) {
        const int at = static_cast<int>(std::sqrt(altitude / top.value) * steps);
        for (int i = std::max(0, at - 1); i <= std::min(steps - 1, at + 1); ++i) jump_within_[static_cast<std::size_t>(i)] = 1;
    }
    for (int i = 0; i <= steps; ++i) {
        const double x = static_cast<double>(i) / steps;
        for (const DensityProfile& profile : profiles) values_.push_back(static_cast<float>(relative_density(profile, x * x * top)));
    }
}

void DensityTable::exact_at(float altitude_m, float* densities) const {
    for (std::size_t p = 0; p < profiles_.size(); ++p)
        densities[p] = static_cast<float>(relative_density(profiles_[p], static_cast<double>(altitude_m) * m));
}

}  // namespace airlight
