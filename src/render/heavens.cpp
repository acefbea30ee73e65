#include "render/heavens.h"

#include <cmath>

#include "atmosphere/sunlight.h"
#include "celestial/moonlight.h"
#include "celestial/night_sky.h"
#include "spectrum/colour.h"
#include "spectrum/solar.h"
#include "sun/position.h"

namespace airlight::render {

namespace {

SpectrumOf<Number> times(const SpectrumOf<Number>& a, const SpectrumOf<Number>& b) {
    std::vector<SpectrumOf<Number>::Sample> samples;
    for (const auto& [wavelength, value] : a.samples()) samples.push_back({wavelength, value * b.at(wavelength)});
    return *SpectrumOf<Number>::of(std::move(samples));
}

RgbLight rgb_of(Xyz colour) {
    const Rgb rgb = RgbConverter(RgbSpace::srgb, WhitePoint::d65).to_rgb(colour);
    return {rgb.r, rgb.g, rgb.b};
}

double angle_between(Vec3 a, Vec3 b) { return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)); }

}  // namespace

double sun_radius(const Heavens& heavens) { return std::asin(std::sin(solar_angular_radius_1au) / heavens.sun_distance_au); }

RgbLight sunlight(const Heavens& heavens, const SpectrumOf<Number>& share) {
    const SpectrumOf<SpectralIrradiance> sun = solar_irradiance(heavens.sun_distance_au);
    std::vector<SpectrumOf<SpectralIrradiance>::Sample> samples;
    for (const auto& [wavelength, irradiance] : sun.samples()) samples.push_back({wavelength, share.at(wavelength) * irradiance});
    return rgb_of(to_xyz(*SpectrumOf<SpectralIrradiance>::of(std::move(samples))));
}

std::array<RgbLight, 3> sun_radiance(const Heavens& heavens) {
    const LimbDarkening limb = solar_limb_darkening();
    const SpectrumOf<SpectralIrradiance> sun = solar_irradiance();
    const double radius = sun_radius(heavens), disk = pi * radius * radius;
    const auto radiance = [&](auto&& numerator) {
        std::vector<SpectrumOf<Number>::Sample> samples;
        for (const auto& sample : sun.samples()) {
            const Wavelength wavelength = sample.x;
            const double u_1 = limb.first.at(wavelength).value, u_2 = limb.second.at(wavelength).value;
            samples.push_back({wavelength, numerator(u_1, u_2) / (1.0 - u_1 / 3.0 - u_2 / 6.0)});
        }
        return sunlight(heavens, *SpectrumOf<Number>::of(std::move(samples))) / disk;
    };
    return {radiance([](double, double) { return 1.0; }), radiance([](double u_1, double) { return u_1; }),
            radiance([](double, double u_2) { return u_2; })};
}

std::optional<MoonSeen> moon_seen(const Heavens& heavens, Vec3 eye_m) {
    if (!heavens.moon_m) return std::nullopt;
    const Vec3 ray = *heavens.moon_m - eye_m;
    const double distance_m = glm::length(ray), sun_m = heavens.sun_distance_au * astronomical_unit.value;
    MoonSeen moon{.towards = ray / distance_m,
                  .angular_radius = std::asin(std::min(moon_radius.value / distance_m, 1.0)),
                  .to_sun = glm::normalize(heavens.towards_sun * sun_m - *heavens.moon_m),
                  .phase_angle = 0.0,
                  .lit = {},
                  .dark = {},
                  .illuminance = {}};
    moon.phase_angle = angle_between(moon.to_sun, -moon.towards);
    const SpectrumOf<Number> albedo = moon_albedo();
    moon.lit = sunlight(heavens, albedo) * (moon_radiance_factor(moon.phase_angle) / pi);
    const Length from_earth = glm::length(*heavens.moon_m) * m;
    const double earths_phase = angle_between(moon.to_sun, -*heavens.moon_m / from_earth.value);
    moon.dark = sunlight(heavens, times(albedo, earthshine_share(earths_phase, from_earth))) / pi;
    moon.illuminance = sunlight(heavens, moonlight_share(moon.phase_angle, distance_m * m));
    return moon;
}

NightLight night_light() {
    const NightSky sky = night_sky();
    return {rgb_of(sky.beyond), rgb_of(sky.airglow), rgb_of(0.5 * mean_luminance(sky)), rgb_of(illuminance(sky))};
}

std::optional<Eclipse> eclipse_of(const Heavens& heavens, Vec3 eye_m, double reach_m) {
    if (!heavens.moon_m) return std::nullopt;
    const Vec3 moon = *heavens.moon_m;
    const double before = glm::dot(moon, heavens.towards_sun), beside = glm::length(glm::cross(moon, heavens.towards_sun));
    const double penumbra_m = moon_radius.value + (before + reach_m) * std::tan(sun_radius(heavens));
    if (before < 0.0 || beside > reach_m + penumbra_m) return std::nullopt;
    return Eclipse{moon - eye_m, moon_radius.value, sun_radius(heavens), heavens.sun_distance_au * astronomical_unit.value};
}

}  // namespace airlight::render
