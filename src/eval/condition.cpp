#include "eval/condition.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "atmosphere/ground.h"

namespace airlight {

namespace {

// Degrees above the geometric horizon, and from the sun's azimuth.
struct HorizonDirection {
    double above_horizon_deg, azimuth_deg;
};

// 90 stands for the zenith, wherever the horizon is. Five are within 6 degrees of the horizon, where paths are longest.
constexpr HorizonDirection within_air[] = {{90.0, 0.0},   {70.0, 120.0}, {50.0, 60.0},   {35.0, 0.0}, {25.0, 180.0}, {15.0, 90.0},
                                           {10.0, 20.0},  {6.0, 150.0},  {4.0, 90.0},    {2.0, 40.0}, {1.0, 0.0},    {0.3, 150.0},
                                           {-0.5, 180.0}, {-5.0, 45.0},  {-30.0, 120.0}, {-80.0, 0.0}};

// Shares of the angle between the horizon and the top of the air, and of that between the horizon and the nadir.
constexpr HorizonDirection across_limb[] = {{0.70, 0.0}, {0.50, 60.0}, {0.28, 180.0}, {0.14, 20.0}, {0.07, 120.0}, {0.03, 90.0}};
constexpr HorizonDirection on_disk[] = {{0.002, 0.0}, {0.015, 150.0}, {0.07, 45.0}, {0.21, 180.0}, {0.57, 120.0}, {0.98, 0.0}};

double grazing_zenith(Length radius, Length bottom, Length altitude) { return pi - std::asin(radius.value / (bottom + altitude).value); }

}  // namespace

Result<Air> air_over(const std::string& name, const Atmosphere& atmosphere, std::string_view ground) {
    if (ground == "own") return Air{name, atmosphere};
    Air air{fmt::format("{} over {}", name, ground), atmosphere};
    if (ground == "black") {
        air.atmosphere.ground_albedo = SpectrumOf<Number>::constant(0.0);
        return air;
    }
    const Result<SpectrumOf<Number>> albedo = ground_material(ground);
    if (!albedo) return albedo.error();
    air.atmosphere.ground_albedo = *albedo;
    return air;
}

std::string condition_text(const Condition& condition) {
    const double altitude_m = condition.altitude.in(m);
    const std::string eye = altitude_m < 1000.0 ? fmt::format("{:g} m", altitude_m) : fmt::format("{:g} km", altitude_m / 1000.0);
    return fmt::format("eye {}, sun {:g}°", eye, condition.sun_zenith_deg);
}

double horizon_zenith(Length bottom_radius, Length altitude) { return grazing_zenith(bottom_radius, bottom_radius, altitude); }

View view_of(const Condition& condition, const Direction& direction) {
    return {condition.altitude, direction.view_zenith, condition.sun_zenith_deg * deg, direction.relative_azimuth};
}

std::vector<JudgedDirection> judged_directions(const Atmosphere& atmosphere, const Condition& condition) {
    std::vector<JudgedDirection> judged;
    const auto add = [&](double zenith, double azimuth_deg, bool above) {
        const Direction direction{std::clamp(zenith, 0.0, pi), azimuth_deg * deg};
        if (std::acos(view_sun_cosine(view_of(condition, direction))) >= 1.0 * deg) judged.push_back({direction, above});
    };
    const double horizon = horizon_zenith(atmosphere.bottom_radius, condition.altitude);
    if (condition.altitude > atmosphere.top_altitude) {
        const double limb =
            horizon - grazing_zenith(atmosphere.bottom_radius + atmosphere.top_altitude, atmosphere.bottom_radius, condition.altitude);
        for (const HorizonDirection d : across_limb) add(horizon - d.above_horizon_deg * limb, d.azimuth_deg, true);
        for (const HorizonDirection d : on_disk) add(horizon + d.above_horizon_deg * (pi - horizon), d.azimuth_deg, false);
        return judged;
    }
    for (const HorizonDirection d : within_air) {
        const bool above = d.above_horizon_deg > 0.0;
        if (!above && condition.altitude == 0.0 * m) continue;  // the ground at no distance
        add(d.above_horizon_deg == 90.0 ? 0.0 : horizon - d.above_horizon_deg * deg, d.azimuth_deg, above);
    }
    return judged;
}

}  // namespace airlight
