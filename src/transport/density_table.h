// The relative densities of all constituents by altitude, tabulated for inner loops.
// Theory: docs/theory.md, section 2. Uses atmosphere (profiles); knows nothing of light.
#pragma once

#include <span>
#include <vector>

#include "atmosphere/density_profile.h"
#include "units/spectral.h"

namespace airlight {

// At most this many constituents; validated() refuses more.
inline constexpr int max_parts = 8;

// Densities at even steps of the root of the altitude (so dense near the ground), linear between them; exact in the steps
// within which one jumps.
// The relative error of an exponential density of scale height H is below (2 sqrt(top h) / (steps H))^2 / 8: 2e-5 for
// Earth's aerosol (H = 1.2 km, top = 100 km).
class DensityTable {
public:
    static constexpr int steps = 4096;

    // `profiles`: 1 to max_parts; `top`: altitude of the top of the atmosphere.
    DensityTable(std::span<const DensityProfile> profiles, Length top);

    int parts() const { return parts_; }

    // Altitudes within the air, in metres, at which a density jumps: rays are cut there, for no rule integrates across a jump.
    std::span<const double> jumps_m() const { return jumps_m_; }

    // The densities at `altitude_m`, one per constituent.
    AIRLIGHT_INLINE void at(float altitude_m, float* densities) const {
        const float x = __builtin_sqrtf(altitude_m > 0.0f ? altitude_m * inverse_top_ : 0.0f) * static_cast<float>(steps);
        const int i = x < static_cast<float>(steps - 1) ? static_cast<int>(x) : steps - 1;
        if (jump_within_[static_cast<std::size_t>(i)]) return exact_at(altitude_m, densities);
        const float t = x < static_cast<float>(steps) ? x - static_cast<float>(i) : 1.0f;
        const float* low = &values_[static_cast<std::size_t>(i) * static_cast<std::size_t>(parts_)];
        for (int p = 0; p < parts_; ++p) densities[p] = low[p] * (1.0f - t) + low[parts_ + p] * t;
    }

private:
    void exact_at(float altitude_m, float* densities) const;

    std::vector<DensityProfile> profiles_;
    int parts_;
    float inverse_top_;
    std::vector<double> jumps_m_;
    std::vector<char> jump_within_;  // [steps]
    std::vector<float> values_;      // [steps + 1][parts]
};

}  // namespace airlight
