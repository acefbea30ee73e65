// A planet with the air of Sperlhofer's thesis, from space to the ground, and what its parameters do. [Sperlhofer2011, sec. 4.7]

#include <fmt/format.h>

#include <cmath>

#include "atmosphere/presets.h"
#include "sheet.h"

namespace airlight::figures {

namespace {

// What the thesis varies; the defaults are those of its table 4-2.
struct PlanetAir {
    double rayleigh = 1.0;             // times 5.8e-3, 1.35e-2 and 3.31e-2 km-1 at 680, 550 and 440 nm
    Length rayleigh_scale = 8.0 * km;  // H_R
    double mie = 1.0;                  // times 4e-3 km-1
    Length mie_scale = 1.2 * km;       // H_M
};

// The thesis' three coefficients are lambda^-4 to 0.4 %: the law itself, so that the whole spectrum is lit.
SpectrumOf<InverseLength> rayleigh_law(double factor) {
    std::vector<SpectrumOf<InverseLength>::Sample> samples;
    for (double wavelength = 300.0; wavelength <= 1000.0; wavelength += 5.0)
        samples.push_back({wavelength * nm, factor * 5.8e-6 * std::pow(680.0 / wavelength, 4.0) * per_m});
    return *SpectrumOf<InverseLength>::of(std::move(samples));
}

// Radii, coefficients, g and the ground's reflectance of table 4-2; the sun is the real one.
Result<Atmosphere> planet(const PlanetAir& air) {
    const Result<Atmosphere> earth = preset("earth-rayleigh");
    if (!earth) return earth.error();
    Atmosphere a{.name = "planet", .bottom_radius = 6360.0 * km, .top_altitude = 60.0 * km, .constituents = {}, .sun = earth->sun};
    a.ground_albedo = SpectrumOf<Number>::constant(0.1);
    a.constituents.push_back({.name = "air",
                              .profile = ExponentialProfile{air.rayleigh_scale},
                              .scattering = rayleigh_law(air.rayleigh),
                              .phase = RayleighPhase{}});
    const double scattering = 4e-6 * air.mie;
    a.constituents.push_back({.name = "aerosol",
                              .profile = ExponentialProfile{air.mie_scale},
                              .scattering = SpectrumOf<InverseLength>::constant(scattering * per_m),
                              .absorption = SpectrumOf<InverseLength>::constant((scattering / 0.9 - scattering) * per_m),
                              .phase = CornetteShanksPhase{SpectrumOf<Number>::constant(0.8)}});
    return a;
}

Result<ShownSky> planet_sky(const Settings& settings, const PlanetAir& air, int orders) {
    const Result<Atmosphere> atmosphere = planet(air);
    if (!atmosphere) return atmosphere.error();
    return shown_sky(settings, "tables", *atmosphere, orders);
}

Shot space() {
    return {.name = "eye at 12000 km",
            .scene = {.altitude = 12000.0 * km, .sun_zenith = 70.0 * deg, .sun_azimuth = 90.0 * deg, .sun_disk = false},
            .camera = {.width = 3, .height = 2, .pitch = -90.0 * deg, .vertical_field_of_view = 50.0 * deg},
            .ev100 = 12.5,
            .probe_zenith = 180.0 * deg,
            .probe_azimuth = 0.0};
}

Shot limb() {
    return {.name = "400 km at sunset",
            .scene = {.altitude = 400.0 * km, .sun_zenith = 108.0 * deg, .sun_azimuth = 0.0},
            .camera = {.width = 3, .height = 2, .heading = 0.0, .pitch = -19.0 * deg, .vertical_field_of_view = 12.0 * deg},
            .ev100 = 12.5,
            .probe_zenith = 109.5 * deg,
            .probe_azimuth = 5.0 * deg};
}

// Over the horizon, with the sun out of the picture.
Shot horizon(double altitude_km, double sun_zenith_deg, double ev100) {
    return {.name = fmt::format("eye at {:g} km", altitude_km),
            .scene = {.altitude = altitude_km * km, .sun_zenith = sun_zenith_deg * deg, .sun_azimuth = 0.0},
            .camera = {.width = 3, .height = 2, .heading = 70.0 * deg, .pitch = 4.0 * deg, .vertical_field_of_view = 50.0 * deg},
            .ev100 = ev100,
            .probe_zenith = 70.0 * deg,
            .probe_azimuth = 70.0 * deg};
}

// On the ground, after the sun has set.
Shot dusk() {
    Shot shot = horizon(0.0, 93.0, 9.0);
    shot.name = "ground at dusk";
    return shot;
}

// Into the sun, noted ten degrees above it.
Shot halo(double altitude_km) {
    return {.name = fmt::format("eye at {:g} km", altitude_km),
            .scene = {.altitude = altitude_km * km, .sun_zenith = 75.0 * deg, .sun_azimuth = 0.0},
            .camera = {.width = 3, .height = 2, .heading = 0.0, .pitch = 10.0 * deg, .vertical_field_of_view = 50.0 * deg},
            .ev100 = 14.1,
            .probe_zenith = 65.0 * deg,
            .probe_azimuth = 0.0};
}

Result<Table> variations(const Settings& settings, std::string_view name, const std::vector<Shot>& shots,
                         const std::vector<std::pair<std::string, PlanetAir>>& airs) {
    std::vector<Variation> columns;
    for (const auto& [label, air] : airs) {
        const Result<ShownSky> sky = planet_sky(settings, air, settings.bake.orders);
        if (!sky) return sky.error();
        columns.push_back({label, *sky});
    }
    return sheet(settings, name, shots, columns);
}

}  // namespace

Result<Table> scattering_orders(const Settings& settings) {
    const Result<ShownSky> once = planet_sky(settings, {}, 1);
    if (!once) return once.error();
    const Result<ShownSky> all = planet_sky(settings, {}, settings.bake.orders);
    if (!all) return all.error();
    return sheet(settings, "scattering_orders", {space(), limb(), horizon(2.0, 60.0, 13.4), dusk()},
                 {{"single", *once}, {"single and multiple", *all}});
}

Result<Table> rayleigh_coefficient(const Settings& settings) {
    return variations(settings, "rayleigh_coefficient", {horizon(2.0, 60.0, 13.4), horizon(5.0, 60.0, 13.4), horizon(20.0, 60.0, 13.4)},
                      {{"β_R halved", {.rayleigh = 0.5}}, {"β_R of the thesis", {}}, {"β_R doubled", {.rayleigh = 2.0}}});
}

Result<Table> rayleigh_scale_height(const Settings& settings) {
    return variations(settings, "rayleigh_scale_height", {horizon(2.0, 60.0, 13.4), horizon(5.0, 60.0, 13.4), horizon(20.0, 60.0, 13.4)},
                      {{"H_R = 2 km", {.rayleigh_scale = 2.0 * km}},
                       {"H_R = 6 km", {.rayleigh_scale = 6.0 * km}},
                       {"H_R = 10 km", {.rayleigh_scale = 10.0 * km}}});
}

Result<Table> mie_coefficient(const Settings& settings) {
    return variations(settings, "mie_coefficient", {halo(1.0), halo(3.0), halo(5.0)},
                      {{"β_M halved", {.mie = 0.5}}, {"β_M of the thesis", {}}, {"β_M doubled", {.mie = 2.0}}});
}

Result<Table> mie_scale_height(const Settings& settings) {
    return variations(
        settings, "mie_scale_height", {halo(1.0), halo(3.0), halo(5.0)},
        {{"H_M = 1 km", {.mie_scale = 1.0 * km}}, {"H_M = 2 km", {.mie_scale = 2.0 * km}}, {"H_M = 4 km", {.mie_scale = 4.0 * km}}});
}

}  // namespace airlight::figures
