#include "sky/pack_phases.h"

#include <algorithm>
#include <cmath>

#include "transport/pack_arithmetic.h"

namespace airlight {

namespace {

// Linear between them, the presets are within 1e-5 and a peak of one degree within 1e-4.
constexpr int sample_count = 1025;

}  // namespace

PackPhases::PackPhases(const AirOptics& optics) : wavelength_count_(optics.wavelength_count) {
    for (std::size_t p = 0; p < optics.parts.size(); ++p)
        if (optics.parts[p].scatters) parts_.push_back(p);
    for (int k = 0; k < sample_count; ++k) {
        const double u = static_cast<double>(k) / (sample_count - 1), nu = std::cos(pi * u * u);
        for (const std::size_t p : parts_) samples_.push_back(narrowed<f32::PhaseSpectrum>(optics.parts[p].phase.at(nu)));
    }
}

PackPhases::Place PackPhases::place(double nu) {
    const double u = std::sqrt(std::acos(std::clamp(nu, -1.0, 1.0)) / pi) * (sample_count - 1);
    const int low = std::min(static_cast<int>(u), sample_count - 2);
    return {static_cast<std::size_t>(low), static_cast<float>(u - low)};
}

}  // namespace airlight
