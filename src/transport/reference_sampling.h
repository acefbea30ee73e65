// Random numbers and directions for the Monte Carlo reference.
// Theory: docs/theory.md, section 4. Uses air optics; knows nothing of paths.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "transport/air_optics.h"
#include "units/vector.h"

namespace airlight {

// A stream of its own for each (seed, stream), so that results do not depend on who draws when. SplitMix64 [Steele2014].
class Random {
public:
    Random(std::uint64_t seed, std::uint64_t stream)
        : state_(mixed(seed + 0x9e3779b97f4a7c15u) ^ mixed(mixed(stream + 0x2545f4914f6cdd1du))) {}

    // Uniform in [0, 1), in steps of 2^-53.
    double operator()() {
        state_ += 0x9e3779b97f4a7c15u;
        return static_cast<double>(mixed(state_) >> 11) * 0x1p-53;
    }

private:
    static std::uint64_t mixed(std::uint64_t x) {
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
        x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
        return x ^ (x >> 31);
    }
    std::uint64_t state_;
};

// The direction at angles (acos(nu), azimuth) from the unit vector `axis`; the azimuth's origin is arbitrary. [Duff2017]
inline Vec3 turned(const Vec3& axis, double nu, double azimuth) {
    const double sign = std::copysign(1.0, axis.z);
    const double a = -1.0 / (sign + axis.z);
    const double b = axis.x * axis.y * a;
    const Vec3 u(1.0 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x);
    const Vec3 v(b, sign + axis.y * axis.y * a, -axis.y);
    const double sine = std::sqrt(std::max(0.0, (1.0 - nu) * (1.0 + nu)));
    return glm::normalize(sine * std::cos(azimuth) * u + sine * std::sin(azimuth) * v + nu * axis);
}

// Scattering angles drawn from one constituent's phase function at any of the pack's wavelengths. The law drawn from is
// constant on bins even in the root of the angle; its exact density is what density() gives, so the bins add no error.
class DirectionSampler {
public:
    explicit DirectionSampler(const SpectralPhase& phase);

    struct Draw {
        double nu;
        int bin;
    };
    Draw draw(int wavelength, double u, double within) const;
    // Density per solid angle of any draw in this bin, at every wavelength.
    const f64::PhaseSpectrum& density(int bin) const { return density_[static_cast<std::size_t>(bin)]; }

private:
    std::vector<double> edges_;                // [bins + 1] cosines, from 1 down to -1
    std::vector<f64::PhaseSpectrum> density_;  // [bins]
    std::vector<double> cumulative_;           // [wavelength][bins]
};

// A direction on the sun's disk and the disk's radiance there relative to its mean.
class SunSampler {
public:
    SunSampler(const Sun& sun, std::span<const Wavelength, pack_size> wavelengths);

    bool is_point() const { return cap_ == 0.0; }
    Vec3 draw(const Vec3& centre, double u, double v) const { return turned(centre, 1.0 - u * cap_, 2.0 * pi * v); }
    // For the draw with the same u.
    f64::Spectrum weight(double u) const;

private:
    double cap_;  // 1 - cosine of the angular radius
    f64::Spectrum u1_, u2_, mean_;
};

}  // namespace airlight
