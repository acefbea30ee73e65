#include "render/air_eye.h"

#include <algorithm>
#include <cmath>

namespace airlight::render {

AirEye settled(const AirEye& eye) {
    constexpr double altitude_step = 1e-4;
    const double altitude = std::expm1(std::round(std::log1p(std::max(eye.altitude_m, 0.0)) / altitude_step) * altitude_step);
    const double cosine_step = 2e-5 * (1.0 + 4.0 * std::min(altitude / 50e3, 1.0));
    return {altitude, std::clamp(std::round(eye.mu_s / cosine_step) * cosine_step, -1.0, 1.0)};
}

}  // namespace airlight::render
