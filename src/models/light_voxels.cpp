#include "models/light_voxels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.h"

namespace airlight {

namespace {

constexpr int steps = 16;

// A grid over the sphere, even in the cosine of the zenith angle and in azimuth from the sun's: what is nearest to a direction
// is found on it.
constexpr int zeniths = 16;
constexpr int azimuths = 32;

struct GridDirection {
    double mu, sine, cos_azimuth, sin_azimuth;
};
const std::vector<GridDirection>& grid() {
    static const std::vector<GridDirection> all = [] {
        std::vector<GridDirection> directions;
        for (int i = 0; i < zeniths; ++i)
            for (int j = 0; j < azimuths; ++j) {
                const double mu = -1.0 + (2.0 * i + 1.0) / zeniths, azimuth = 2.0 * pi * (j + 0.5) / azimuths;
                directions.push_back({mu, std::sqrt(1.0 - mu * mu), std::cos(azimuth), std::sin(azimuth)});
            }
        return directions;
    }();
    return all;
}

double sine_of(double cosine) { return std::sqrt(std::max(0.0, (1.0 - cosine) * (1.0 + cosine))); }

// Which of the eight directions is nearest to each of the grid's, for a sun.
std::vector<int> nearest(double mu_s) {
    std::vector<int> all;
    for (const GridDirection& w : grid()) {
        const double nu = w.mu * mu_s + w.sine * sine_of(mu_s) * w.cos_azimuth;
        int best = 0;
        for (int j = 1; j < LightVoxels::directions; ++j)
            if (f64::nishita1996_cosine(j, w.mu, mu_s, nu) > f64::nishita1996_cosine(best, w.mu, mu_s, nu)) best = j;
        all.push_back(best);
    }
    return all;
}

// Cosines of the zenith angle of direction j, and to the sun.
struct SampleDirection {
    double mu, nu;
};
SampleDirection sample_direction(int j, double mu_s) {
    const double sin_s = sine_of(mu_s), sign = j % 2 == 0 ? 1.0 : -1.0;
    const std::array<SampleDirection, 4> pairs = {{{1.0, mu_s}, {0.0, sin_s}, {mu_s, 1.0}, {sin_s, 0.0}}};
    const SampleDirection& d = pairs[static_cast<std::size_t>(j / 2)];
    return {sign * d.mu, sign * d.nu};
}

double sun_cosine(int s) { return f64::sun_of_coordinate(static_cast<double>(s) / (LightVoxels::suns - 1)).value; }

std::size_t index(int direction, int sun, int altitude) {
    return static_cast<std::size_t>((direction * LightVoxels::suns + sun) * LightVoxels::altitudes + altitude);
}

}  // namespace

f64::SampledPhases LightVoxels::phases(double mu, double mu_s, double nu) const {
    f64::SampledPhases sums;
    f64::Spectrum whole_air(f64::Number(0.0)), whole_aerosol(f64::Number(0.0));
    for (int j = 0; j < directions; ++j) sums.air[j] = sums.aerosol[j] = f64::Spectrum(f64::Number(0.0));
    const double cos_azimuth = f64::relative_azimuth_cosine(mu, mu_s, nu).value, sin_azimuth = sine_of(cos_azimuth), sine = sine_of(mu);
    const std::vector<int> region = nearest(mu_s);
    for (std::size_t k = 0; k < grid().size(); ++k) {
        const GridDirection& w = grid()[k];
        const double cosine =
            std::clamp(mu * w.mu + sine * w.sine * (cos_azimuth * w.cos_azimuth + sin_azimuth * w.sin_azimuth), -1.0, 1.0);
        const f64::Spectrum of_air = air_.air_phase(cosine) / f64::per_sr, of_aerosol = air_.aerosol_phase(cosine) / f64::per_sr;
        sums.air[region[k]] += of_air;
        sums.aerosol[region[k]] += of_aerosol;
        whole_air += of_air;
        whole_aerosol += of_aerosol;
    }
    // The grid is coarse beside a forward peak: what is scattered is all that there is.
    const f64::Spectrum tiny(f64::Number(1e-300));
    for (int j = 0; j < directions; ++j) {
        sums.air[j] = sums.air[j] / max(whole_air, tiny);
        sums.aerosol[j] = sums.aerosol[j] / max(whole_aerosol, tiny);
    }
    return sums;
}

f64::PhaseSpectrum LightVoxels::light_of(const Voxels& voxels, const f64::SampledPhases& phases, const f64::AirRay& ray) const {
    const Table3D<f64::PhaseSpectrum> table(voxels, altitudes, suns, directions);
    return f64::nishita1996_light(air_.air, air_.air_scattering, air_.aerosol_scattering, table, altitudes, suns, phases, ray, steps);
}

f64::PhaseSpectrum LightVoxels::ground_light_of(const Voxels& voxels, double mu_s) const {
    const Table3D<f64::PhaseSpectrum> table(voxels, altitudes, suns, directions);
    const std::vector<int> region = nearest(mu_s);
    std::array<double, directions> cosines{};
    for (std::size_t k = 0; k < grid().size(); ++k)
        cosines[static_cast<std::size_t>(region[k])] += 4.0 / (zeniths * azimuths) * std::max(grid()[k].mu, 0.0);
    f64::PhaseSpectrum sum(0.0 * f64::per_sr);
    for (int j = 0; j < directions; ++j)
        sum += f64::nishita1996_voxel(air_.air, table, altitudes, suns, 0.0 * f64::m, mu_s, j) *
               f64::Number(cosines[static_cast<std::size_t>(j)]);
    return sum;
}

f64::PhaseSpectrum LightVoxels::first_light(const DensitySpheres& spheres, const f64::AirRay& ray, const f64::SampledPhases& from_sun,
                                            double region, int j) const {
    // The mean of the phase function over the directions that this one stands for, in whose midst the sun's peak may be.
    const f64::ScatteredLight once = spheres.light(ray);
    const f64::InverseSolidAngle per_region = 1.0 / region * f64::per_sr;
    return (once.air * air_.air_scattering * from_sun.air[j] + once.aerosol * air_.aerosol_scattering * from_sun.aerosol[j]) * per_region;
}

LightVoxels::LightVoxels(const TwoConstituents& air, const DensitySpheres& spheres, int orders) : air_(air) {
    const std::size_t count = static_cast<std::size_t>(directions) * suns * altitudes;
    const f64::PhaseSpectrum none(0.0 * f64::per_sr);
    voxels_.assign(count, none);
    Voxels before(count, none);
    for (int order = 1; order < orders; ++order) {
        Voxels pass(count, none);
        parallel_for(suns, [&](std::size_t sun) {
            const int s = static_cast<int>(sun);
            const double mu_s = sun_cosine(s);
            const std::vector<int> region = nearest(mu_s);
            const f64::SampledPhases from_sun = phases(mu_s, mu_s, 1.0);
            for (int j = 0; j < directions; ++j) {
                const SampleDirection d = sample_direction(j, mu_s);
                const f64::SampledPhases scattered = order > 1 ? phases(d.mu, mu_s, d.nu) : from_sun;
                const double share = static_cast<double>(std::count(region.begin(), region.end(), j)) / static_cast<double>(region.size());
                for (int i = 0; i < altitudes; ++i) {
                    const f64::Length h = f64::nishita1993_sphere(air_.air.top, air_.air.air_scale_height, i, altitudes);
                    const f64::AirRay ray = f64::air_ray(h, d.mu, mu_s, d.nu, f64::distance_in_air(air_.air, h, d.mu));
                    f64::PhaseSpectrum& voxel = pass[index(j, s, i)];
                    if (order > 1) voxel = light_of(before, scattered, ray);
                    else if (share > 0.0) voxel = first_light(spheres, ray, from_sun, 4.0 * pi * share, j);
                    if (!f64::meets_ground(h, d.mu, air_.air.bottom)) continue;
                    const double at_ground = f64::sun_cosine_at(h, mu_s, d.nu, ray.reach, 0.0 * f64::m, air_.air.bottom).value;
                    f64::PhaseSpectrum lit = none;
                    if (order > 1) lit = ground_light_of(before, at_ground);
                    else
                        lit = f64::PhaseSpectrum(std::max(at_ground, 0.0) / f64::pi * f64::per_sr) *
                              spheres.sunlight(0.0 * f64::m, at_ground);
                    voxel += exp(-spheres.light(ray).depth) * air_.optics.ground_albedo * lit;
                }
            }
        });
        for (std::size_t k = 0; k < count; ++k) voxels_[k] += pass[k];
        before = std::move(pass);
    }
}

f64::PhaseSpectrum LightVoxels::light(const f64::AirRay& ray) const {
    return light_of(voxels_, phases(ray.mu.value, ray.mu_s.value, ray.nu.value), ray);
}

f64::PhaseSpectrum LightVoxels::on_ground(double mu_s) const { return ground_light_of(voxels_, mu_s); }

}  // namespace airlight
