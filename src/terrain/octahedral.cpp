#include "terrain/octahedral.h"

#include <cmath>

namespace airlight {

namespace {

constexpr double steps = 65535.0;

double sign(double x) { return x < 0.0 ? -1.0 : 1.0; }

std::uint32_t level(double x) { return static_cast<std::uint32_t>(std::lround((0.5 * x + 0.5) * steps)); }

}  // namespace

std::uint32_t octahedral(Vec3 d) {
    const double sum = std::abs(d.x) + std::abs(d.y) + std::abs(d.z);
    double x = d.x / sum, y = d.y / sum;
    if (d.z < 0.0) {
        const double folded = (1.0 - std::abs(y)) * sign(x);
        y = (1.0 - std::abs(x)) * sign(y);
        x = folded;
    }
    return level(x) | level(y) << 16;
}

Vec3 from_octahedral(std::uint32_t packed) {
    double x = (packed & 0xffff) / steps * 2.0 - 1.0, y = (packed >> 16) / steps * 2.0 - 1.0;
    const double z = 1.0 - std::abs(x) - std::abs(y);
    if (z < 0.0) {
        const double folded = (1.0 - std::abs(y)) * sign(x);
        y = (1.0 - std::abs(x)) * sign(y);
        x = folded;
    }
    return glm::normalize(Vec3(x, y, z));
}

}  // namespace airlight
