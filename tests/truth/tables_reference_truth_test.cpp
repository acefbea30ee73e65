// The sky from tables against the Monte Carlo reference, in the air of presets: by sun and eye, and across the horizon.
// The error of a set of directions is sqrt(mean((tables / reference - 1)^2)) over directions and wavelengths, less the
// reference's own relative variance; where that noise is itself beyond the bound, nothing is shown. Directions within 1 degree
// of the sun are left out: there the sun's disk smears the forward peak of the aerosol, which tables take for a point's.
// So is what is darker than 1e-8 of the solar irradiance per steradian.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdio>

#include "bakes.h"
#include "transport/reference.h"

using namespace airlight;

namespace {

// Degrees above the geometric horizon, and from the sun's azimuth.
struct HorizonDirection {
    double above_horizon_deg, azimuth_deg;
};
const std::vector<HorizonDirection> from_within = {{85.0, 0.0},  {50.0, 60.0},  {25.0, 180.0}, {10.0, 20.0},   {4.0, 90.0}, {1.0, 0.0},
                                                   {0.3, 150.0}, {-0.5, 180.0}, {-5.0, 45.0},  {-30.0, 120.0}, {-80.0, 0.0}};
// The limb is 2.2 degrees high at 400 km; the disk of the Earth fills 140 degrees.
const std::vector<HorizonDirection> from_space = {{1.5, 0.0},    {1.0, 60.0},  {0.6, 180.0},   {0.3, 20.0},    {0.1, 90.0}, {-0.1, 0.0},
                                                  {-1.0, 150.0}, {-5.0, 45.0}, {-15.0, 180.0}, {-40.0, 120.0}, {-69.0, 0.0}};

double horizon_zenith(Length bottom_radius, Length altitude) {
    return pi - std::asin(bottom_radius.value / (bottom_radius + altitude).value);
}

double angle_to_sun(const View& v) {
    return std::acos(std::clamp(
        std::cos(v.view_zenith) * std::cos(v.sun_zenith) + std::sin(v.view_zenith) * std::sin(v.sun_zenith) * std::cos(v.relative_azimuth),
        -1.0, 1.0));
}

// A preset in all its forms.
struct Truth {
    explicit Truth(const std::string& name)
        : atmosphere(*preset(name)),
          wavelengths(truth::sixteen_wavelengths()),
          reference(*Reference::of(atmosphere, wavelengths)),
          sky(truth::preset_sky(name)) {}
    View view(Length altitude, double sun_deg, HorizonDirection d) const {
        return {altitude, std::max(0.0, horizon_zenith(atmosphere.bottom_radius, altitude) - d.above_horizon_deg * deg), sun_deg * deg,
                d.azimuth_deg * deg};
    }
    Atmosphere atmosphere;
    std::vector<Wavelength> wavelengths;
    Reference reference;
    const TableSky& sky;
};

// Of one sun and one eye.
struct Deviation {
    int values = 0, dark = 0;
    double square = 0.0, variance = 0.0, worst = 0.0;
    std::string worst_row;

    void add(const Truth& truth, const View& view, std::int64_t paths) {
        const RadianceEstimate exact = *truth.reference.radiance(view, {.paths = paths, .seed = 20260103});
        const RadianceEstimate found = *truth.sky.radiance(view);
        for (std::size_t w = 0; w < truth.wavelengths.size(); ++w) {
            const double r = exact.radiance_W_m2_sr_nm[w];
            if (r < 1e-8 * truth.atmosphere.sun.irradiance.at(truth.wavelengths[w]).in(W_per_m2_nm)) {
                ++dark;
                continue;
            }
            const double deviation = found.radiance_W_m2_sr_nm[w] / r - 1.0, error = exact.standard_error[w] / r;
            ++values;
            square += deviation * deviation;
            variance += error * error;
            if (std::abs(deviation) - 2.0 * error < worst) continue;
            worst = std::abs(deviation) - 2.0 * error;
            worst_row = fmt::format("view {:.2f} azimuth {:.0f} at {:.0f} nm {:+.2f} % +- {:.2f} %", view.view_zenith / deg,
                                    view.relative_azimuth / deg, truth.wavelengths[w].in(nm), 100.0 * deviation, 100.0 * error);
        }
    }
    double noise() const { return std::sqrt(variance / values); }
    double plain() const { return std::sqrt(square / values); }
    double own() const { return std::sqrt(std::max(0.0, square - variance) / values); }
};

// Light of twilight comes by rare paths through lit air far away: with too few of them the reference reads too dark, and its
// standard error too small. From space, beyond the terminator, the rarest.
std::int64_t paths_for(double sun_deg, double eye_km) {
    if (sun_deg < 80.0) return 16'384;
    return eye_km > 100.0 && sun_deg > 85.0 ? 1'600'000 : 400'000;
}

void compare(const std::string& name, const std::vector<double>& suns_deg, const std::vector<double>& eyes_km) {
    const Truth truth(name);
    for (const double sun : suns_deg)
        for (const double eye : eyes_km) {
            Deviation deviation;
            for (const HorizonDirection d : eye > 100.0 ? from_space : from_within) {
                const View view = truth.view(eye * km, sun, d);
                if (angle_to_sun(view) >= 1.0 * deg) deviation.add(truth, view, paths_for(sun, eye));
            }
            if (deviation.values == 0) continue;
            fmt::print("  {} sun {:>2} eye {:>3} km: {:5.2f} % (plain {:5.2f} %, reference {:5.2f} %) of {} values, {} dark; worst: {}\n",
                       name, sun, eye, 100.0 * deviation.own(), 100.0 * deviation.plain(), 100.0 * deviation.noise(), deviation.values,
                       deviation.dark, deviation.worst_row);
            CAPTURE(sun);
            CAPTURE(eye);
            std::fflush(stdout);
            const double bound = sun <= 85.0 ? 0.02 : 0.05;
            CHECK(deviation.own() <= bound);
            CHECK(deviation.noise() <= bound);
        }
}

}  // namespace

TEST_CASE("tables are within 2 % of the reference by day and within 5 % in twilight, from the ground to space") {
    if (truth::full())
        for (const char* name : {"earth-clear", "earth-hazy"})
            compare(name, {0.0, 30.0, 60.0, 75.0, 85.0, 90.0, 93.0, 96.0}, {0.0, 2.0, 10.0, 30.0, 400.0});
    else compare("earth-clear", {60.0}, {0.0});
}

// The step across the horizon, radiance below over radiance above, is real: below ends at the ground, above goes on. Tables must
// have it as the reference has it, within 3 % and four standard errors of a step that single rays and the dome both take.
TEST_CASE("the step of radiance across the horizon is the reference's") {
    const Truth truth("earth-clear");
    const std::vector<double> suns = truth::full() ? std::vector<double>{30.0, 85.0, 94.0} : std::vector<double>{85.0};
    for (const double altitude_m : truth::full() ? std::vector<double>{2.0, 2000.0, 10'000.0, 400'000.0} : std::vector<double>{2.0})
        for (const double sun : suns) {
            const auto dome = *truth.sky.dome(altitude_m * m, sun * deg);
            for (const double offset : truth::full() ? std::vector<double>{0.01, 0.1, 0.5} : std::vector<double>{0.05}) {
                const View above = truth.view(altitude_m * m, sun, {offset, 60.0}),
                           below = truth.view(altitude_m * m, sun, {-offset, 60.0});
                const ReferenceSettings settings{.paths = truth::full() ? 32768 : 8192, .seed = 5};
                const RadianceEstimate exact_above = *truth.reference.radiance(above, settings),
                                       exact_below = *truth.reference.radiance(below, settings);
                const RadianceEstimate ray_above = *truth.sky.radiance(above), ray_below = *truth.sky.radiance(below);
                std::vector<float> dome_above(truth.wavelengths.size()), dome_below(truth.wavelengths.size());
                dome->radiance(above.view_zenith, above.relative_azimuth, dome_above);
                dome->radiance(below.view_zenith, below.relative_azimuth, dome_below);
                for (std::size_t w = 2; w < truth.wavelengths.size(); w += 5) {
                    const double a = exact_above.radiance_W_m2_sr_nm[w], b = exact_below.radiance_W_m2_sr_nm[w], step = b / a;
                    const double error = std::hypot(exact_above.standard_error[w] / a, exact_below.standard_error[w] / b);
                    const double by_rays = ray_below.radiance_W_m2_sr_nm[w] / ray_above.radiance_W_m2_sr_nm[w],
                                 by_dome = static_cast<double>(dome_below[w]) / dome_above[w];
                    fmt::print(
                        "  eye {:>6} m sun {} +-{:.2f} deg {:.0f} nm: below over above {:.4f} +- {:.1f} %, rays {:.4f} ({:+.1f} %), dome "
                        "{:.4f} ({:+.1f} %)\n",
                        altitude_m, sun, offset, truth.wavelengths[w].in(nm), step, 100.0 * error, by_rays, 100.0 * (by_rays / step - 1.0),
                        by_dome, 100.0 * (by_dome / step - 1.0));
                    CHECK(std::abs(by_rays / step - 1.0) <= 0.03 + 4.0 * error);
                    CHECK(std::abs(by_dome / step - 1.0) <= 0.03 + 4.0 * error);
                }
            }
        }
}
