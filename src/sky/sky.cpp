#include "sky/sky.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "physics/f64.h"

namespace airlight {

namespace {

// Asks the sky for each direction.
class DirectDome : public SkyDome {
public:
    DirectDome(const Sky& sky, Length altitude, double sun_zenith) : sky_(sky), altitude_(altitude), sun_zenith_(sun_zenith) {}

    void radiance(double view_zenith, double relative_azimuth, std::span<float> radiance) const override {
        const Result<RadianceEstimate> seen = sky_.radiance({altitude_, view_zenith, sun_zenith_, relative_azimuth});
        for (std::size_t i = 0; i < radiance.size(); ++i) radiance[i] = seen ? static_cast<float>(seen->radiance_W_m2_sr_nm[i]) : 0.0f;
    }

private:
    const Sky& sky_;
    Length altitude_;
    double sun_zenith_;
};

}  // namespace

Result<std::unique_ptr<SkyDome>> Sky::dome(Length altitude, double sun_zenith) const {
    // One question tells whether the model can answer for this eye and sun.
    if (const Result<RadianceEstimate> seen = radiance({altitude, 0.25 * pi, sun_zenith, 0.5 * pi}); !seen) return seen.error();
    return std::unique_ptr<SkyDome>(std::make_unique<DirectDome>(*this, altitude, sun_zenith));
}

void SkyDome::radiances(std::span<const Direction> directions, std::span<float> radiance) const {
    assert(directions.empty() || radiance.size() % directions.size() == 0);
    const std::size_t n = directions.empty() ? 0 : radiance.size() / directions.size();
    for (std::size_t i = 0; i < directions.size(); ++i)
        this->radiance(directions[i].view_zenith, directions[i].relative_azimuth, radiance.subspan(i * n, n));
}

Result<AerialPerspective> Sky::aerial_perspective(const View&, Length) const {
    return Error{name(), "has no aerial perspective", "`airlight models` shows which models have it."};
}

Result<std::vector<double>> Sky::sunlight_transmittance(Length altitude, double view_zenith) const {
    const f64::Length h = f64::Length::of(altitude.value);
    if (f64::meets_ground(h, std::cos(view_zenith), f64::Length::of(bottom_radius().value)))
        return std::vector<double>(wavelengths().size(), 0.0);
    return transmittance(altitude, view_zenith, 1e12 * m);
}

std::vector<double> sun_disk_radiance(const Sun& sun, std::span<const Wavelength> wavelengths, double angle) {
    std::vector<double> radiance(wavelengths.size(), 0.0);
    if (!(angle < sun.angular_radius)) return radiance;
    const double s = angle / sun.angular_radius;
    const double mu = std::sqrt(1.0 - s * s);  // cosine between the line of sight and the sun's surface
    for (std::size_t i = 0; i < wavelengths.size(); ++i) {
        const double u1 = sun.limb_darkening_1.at(wavelengths[i]).value;
        const double u2 = sun.limb_darkening_2.at(wavelengths[i]).value;
        const double shape = 1.0 - u1 * (1.0 - mu) - u2 * (1.0 - mu) * (1.0 - mu);
        const double mean_shape = 1.0 - u1 / 3.0 - u2 / 6.0;
        const double solid_angle = 2.0 * pi * (1.0 - std::cos(sun.angular_radius));
        radiance[i] = sun.irradiance.at(wavelengths[i]).value / solid_angle * shape / mean_shape;
    }
    return radiance;
}

double view_sun_cosine(const View& v) {
    return std::clamp(
        std::cos(v.view_zenith) * std::cos(v.sun_zenith) + std::sin(v.view_zenith) * std::sin(v.sun_zenith) * std::cos(v.relative_azimuth),
        -1.0, 1.0);
}

Result<Done> check_view(Length altitude, double view_zenith, double sun_zenith, double relative_azimuth) {
    if (!std::isfinite(altitude.value) || altitude < 0.0 * m)
        return Error{"eye altitude", fmt::format("{} m is below the ground: it must be 0 m or more", altitude.value), ""};
    if (!(view_zenith >= 0.0 && view_zenith <= pi))
        return Error{"view zenith angle", fmt::format("{} deg is out of range: it must be 0 to 180 deg", view_zenith / deg), ""};
    if (!(sun_zenith >= 0.0 && sun_zenith <= pi))
        return Error{"sun zenith angle", fmt::format("{} deg is out of range: it must be 0 to 180 deg", sun_zenith / deg), ""};
    if (!std::isfinite(relative_azimuth)) return Error{"relative azimuth", "is not finite", ""};
    return Done{};
}

}  // namespace airlight
