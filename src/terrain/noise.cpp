#include "terrain/noise.h"

#include <cmath>

namespace airlight {

namespace {

// A mixer of 64 bits [Steele2014, "Mix13"].
std::uint64_t mix(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

std::uint64_t hash(std::int64_t x, std::int64_t y, std::int64_t z, std::uint32_t seed) {
    const std::uint64_t a = static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15u;
    const std::uint64_t b = static_cast<std::uint64_t>(y) * 0xc2b2ae3d27d4eb4fu;
    const std::uint64_t c = static_cast<std::uint64_t>(z) * 0x165667b19e3779f9u;
    return mix(a ^ (b << 1 | b >> 63) ^ (c << 2 | c >> 62) ^ seed * 0x2545f4914f6cdd1du);
}

// The middles of a cube's edges, of length one.
Vec3 lattice_gradient(std::int64_t x, std::int64_t y, std::int64_t z, std::uint32_t seed) {
    const std::uint64_t h = hash(x, y, z, seed) >> 33;
    constexpr double s = 0.7071067811865476;
    const double a = h & 1 ? s : -s, b = h & 2 ? s : -s;
    switch ((h >> 2) % 3) {
        case 0:
            return {a, b, 0.0};
        case 1:
            return {a, 0.0, b};
        default:
            return {0.0, a, b};
    }
}

double fade(double t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); }
double fade_slope(double t) { return 30.0 * t * t * (t * (t - 2.0) + 1.0); }

}  // namespace

NoiseSample gradient_noise(Vec3 p, std::uint32_t seed) {
    const Vec3 floor(std::floor(p.x), std::floor(p.y), std::floor(p.z));
    const auto x = static_cast<std::int64_t>(floor.x), y = static_cast<std::int64_t>(floor.y), z = static_cast<std::int64_t>(floor.z);
    const Vec3 t = p - floor;
    const double wx[] = {1.0 - fade(t.x), fade(t.x)}, wy[] = {1.0 - fade(t.y), fade(t.y)}, wz[] = {1.0 - fade(t.z), fade(t.z)};
    const Vec3 slope(fade_slope(t.x), fade_slope(t.y), fade_slope(t.z));
    NoiseSample sample{0.0, Vec3(0.0)};
    for (int k = 0; k < 2; ++k)
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i) {
                const Vec3 g = lattice_gradient(x + i, y + j, z + k, seed);
                const double plane = glm::dot(g, t - Vec3(i, j, k));
                const double weight = wx[i] * wy[j] * wz[k];
                sample.value += weight * plane;
                sample.gradient +=
                    weight * g + plane * Vec3((i ? slope.x : -slope.x) * wy[j] * wz[k], (j ? slope.y : -slope.y) * wx[i] * wz[k],
                                              (k ? slope.z : -slope.z) * wx[i] * wy[j]);
            }
    return sample;
}

}  // namespace airlight
