#include "terrain/procedural_relief.h"

#include <algorithm>
#include <cmath>

#include "terrain/noise.h"

namespace airlight {

namespace {

// Calls body(wavelength, amplitude, seed) for each octave, widest first.
template <class Body>
void each_octave(const Octaves& o, Body body) {
    const double gain = std::pow(0.5, o.smoothness);
    double amplitude = o.amplitude_m;
    std::uint32_t seed = o.seed << 8;
    for (double wavelength = o.wavelength_m; wavelength >= o.narrowest_m; wavelength *= 0.5, amplitude *= gain)
        body(wavelength, amplitude, seed++);
}

double smooth_step(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}
double smooth_step_slope(double t) { return t > 0.0 && t < 1.0 ? 6.0 * t * (1.0 - t) : 0.0; }

// What of a gradient is along the sphere.
Vec3 tangential(Vec3 gradient, Vec3 direction) { return gradient - glm::dot(gradient, direction) * direction; }

double share(const ProceduralRelief& r, double continent_m) {
    return r.least_share + (1.0 - r.least_share) * smooth_step(continent_m / r.full_at_m);
}
double share_slope(const ProceduralRelief& r, double continent_m) {
    return (1.0 - r.least_share) * smooth_step_slope(continent_m / r.full_at_m) / r.full_at_m;
}

HeightSample sample(const ProceduralRelief& r, Vec3 d, double width_m) {
    const NoiseRelief low = noise_relief(r.continents, r.radius_m, d, width_m), high = noise_relief(r.mountains, r.radius_m, d, width_m);
    const double land = r.mean_m + low.height_m, s = share(r, land), ds = share_slope(r, land);
    return {land + s * high.height_m, (1.0 + ds * high.height_m) * low.slope + s * high.slope,
            (1.0 + ds * high.height_m) * low.coarse_slope + s * high.coarse_slope,
            (1.0 + ds * high.height_m) * low.broad_slope + s * high.broad_slope};
}

Interval range(const ProceduralRelief& r, const Cap& cap) {
    const Interval low = noise_relief_range(r.continents, r.radius_m, cap), high = noise_relief_range(r.mountains, r.radius_m, cap);
    const double land_low = r.mean_m + low.low, land_high = r.mean_m + low.high;
    const double s_low = share(r, land_low), s_high = share(r, land_high);
    return {land_low + std::min(s_low * high.low, s_high * high.low), land_high + std::max(s_low * high.high, s_high * high.high)};
}

}  // namespace

double slope_weight(double wavelength_m, double width_m) { return std::clamp(wavelength_m / width_m - 1.0, 0.0, 1.0); }

NoiseRelief noise_relief(const Octaves& octaves, double radius_m, Vec3 d, double width_m) {
    NoiseRelief sum{0.0, Vec3(0.0), Vec3(0.0), Vec3(0.0)};
    each_octave(octaves, [&](double wavelength, double amplitude, std::uint32_t seed) {
        const NoiseSample n = gradient_noise(d * (radius_m / wavelength), seed);
        const double scale = amplitude / noise_bound;
        sum.height_m += scale * n.value;
        sum.slope += scale / wavelength * slope_weight(wavelength, width_m) * n.gradient;
        sum.coarse_slope += scale / wavelength * slope_weight(wavelength, 2.0 * width_m) * n.gradient;
        sum.broad_slope += scale / wavelength * slope_weight(wavelength, broad_width_m) * n.gradient;
    });
    sum.slope = tangential(sum.slope, d);
    sum.coarse_slope = tangential(sum.coarse_slope, d);
    sum.broad_slope = tangential(sum.broad_slope, d);
    return sum;
}

Interval noise_relief_range(const Octaves& octaves, double radius_m, const Cap& cap) {
    Interval sum;
    // No chord of the cap from its middle is longer than its arc.
    const double reach_m = radius_m * cap.angle;
    each_octave(octaves, [&](double wavelength, double amplitude, std::uint32_t seed) {
        const double scale = amplitude / noise_bound, change = scale * noise_slope_bound * reach_m / wavelength;
        const double middle = change < amplitude ? scale * gradient_noise(cap.centre * (radius_m / wavelength), seed).value : 0.0;
        sum.low += std::max(-amplitude, middle - change);
        sum.high += std::min(amplitude, middle + change);
    });
    return sum;
}

double largest_noise_relief(const Octaves& octaves) {
    double sum = 0.0;
    each_octave(octaves, [&](double, double amplitude, std::uint32_t) { sum += amplitude; });
    return sum;
}

double noise_relief_detail(const Octaves& o, double spacing_m) {
    if (spacing_m > 2.0 * o.wavelength_m || spacing_m < 0.5 * o.narrowest_m) return 0.0;
    return o.amplitude_m * std::pow(spacing_m / o.wavelength_m, o.smoothness);
}

HeightField procedural_height(const ProceduralRelief& r) {
    const double low = largest_noise_relief(r.continents), high = largest_noise_relief(r.mountains);
    return {.radius_m = r.radius_m,
            .sample = [r](Vec3 d, double width_m) { return sample(r, d, width_m); },
            .range = [r](const Cap& cap) { return range(r, cap); },
            .detail =
                [r](double spacing_m) {
                    return std::max(noise_relief_detail(r.continents, spacing_m), noise_relief_detail(r.mountains, spacing_m));
                },
            .whole = {r.mean_m - low - high, r.mean_m + low + high},
            .sea = r.sea};
}

}  // namespace airlight
