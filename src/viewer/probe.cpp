#include "viewer/probe.h"

#include <algorithm>
#include <cmath>

#include "terrain/cube_sphere.h"

namespace airlight::viewer {

namespace {

std::vector<float> evenly(std::span<const Wavelength> wavelengths, std::span<const double> values) {
    std::vector<float> even;
    std::size_t after = 1;
    for (Wavelength w = wavelengths.front(); w <= wavelengths.back(); w = w + spectrum_step_nm * nm) {
        while (after + 1 < wavelengths.size() && wavelengths[after] < w) ++after;
        const double t = ((w - wavelengths[after - 1]) / (wavelengths[after] - wavelengths[after - 1])).value;
        even.push_back(static_cast<float>((1.0 - t) * values[after - 1] + t * values[after]));
    }
    return even;
}

Result<std::vector<float>> sun_plane_of(const Sky& sky, const ColourWeights& colour, const View& view) {
    std::vector<float> plane;
    for (double from_sun_side = -90.0; from_sun_side <= 90.0; from_sun_side += sun_plane_step_deg) {
        const View there{view.altitude, std::abs(from_sun_side) * deg, view.sun_zenith, from_sun_side < 0.0 ? 0.0 : pi};
        const Result<RadianceEstimate> light = sky.radiance(there);
        if (!light) return light.error();
        plane.push_back(static_cast<float>(colour.to_xyz(light->radiance_W_m2_sr_nm).y));
    }
    return plane;
}

}  // namespace

View view_of(const ProbedView& v) {
    const Vec3 up = glm::normalize(v.eye_m);
    const Vec3 level = v.direction - glm::dot(v.direction, up) * up, sun_level = v.towards_sun - glm::dot(v.towards_sun, up) * up;
    return {std::max(glm::length(v.eye_m) - v.bottom_m, 0.0) * m, angle_between(v.direction, up), angle_between(v.towards_sun, up),
            angle_between(level, sun_level)};
}

Result<Probe> probed(const Sky& sky, const ColourWeights& colour, const ProbedView& v) {
    const View view = view_of(v);
    const Result<RadianceEstimate> there = sky.radiance(view);
    if (!there) return there.error();
    Result<std::vector<float>> plane = sun_plane_of(sky, colour, view);
    if (!plane) return plane.error();
    return Probe{colour.to_xyz(there->radiance_W_m2_sr_nm).y, sky.wavelengths().front().in(nm),
                 evenly(sky.wavelengths(), there->radiance_W_m2_sr_nm), *std::move(plane)};
}

}  // namespace airlight::viewer
