// Descriptions of atmospheres: the rules that they keep, and their columns.

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <sstream>

#include "atmosphere/coefficients.h"
#include "atmosphere/model_atmosphere.h"
#include "atmosphere/validate.h"

using namespace airlight;

namespace {

SpectrumOf<InverseLength> coefficient(double per_metre) { return SpectrumOf<InverseLength>::constant(per_metre * per_m); }

Atmosphere plain() {
    Atmosphere a;
    a.name = "plain";
    a.bottom_radius = 6371.0 * km;
    a.top_altitude = 100.0 * km;
    a.constituents = {{"air", ExponentialProfile{8.0 * km}, coefficient(1e-5), coefficient(0.0), RayleighPhase{0.0279}},
                      {"haze", ExponentialProfile{1.2 * km}, coefficient(3e-5), coefficient(1e-5),
                       HenyeyGreensteinPhase{SpectrumOf<Number>::constant(0.76)}},
                      {"ozone", TriangleProfile{10.0 * km, 25.0 * km, 40.0 * km}, coefficient(0.0), coefficient(1e-6), IsotropicPhase{}}};
    a.ground_albedo = SpectrumOf<Number>::constant(0.1);
    a.sun.angular_radius = 0.2666 * deg;
    return a;
}

SpectrumOf<Number> numbers(double at_400, double at_700) { return *SpectrumOf<Number>::of({{400.0 * nm, at_400}, {700.0 * nm, at_700}}); }

}  // namespace

TEST_CASE("a plain description keeps every rule, also on the largest planet, and is returned as it was") {
    Atmosphere a = plain();
    REQUIRE(validated(a));
    CHECK(*validated(a) == a);
    a.bottom_radius = max_bottom_radius;
    CHECK(validated(a));
    a.constituents.clear();
    CHECK(validated(a));
}

TEST_CASE("each rule that a description breaks is named by its key, its value and the rule") {
    struct Case {
        const char* message;
        std::function<void(Atmosphere&)> spoil;
    };
    const Case cases[] = {
        {"planet.radius = \"99 km\" is out of range: it must be from 100 km to 1000000000 km",
         [](Atmosphere& a) { a.bottom_radius = 99.0 * km; }},
        {"planet.radius", [](Atmosphere& a) { a.bottom_radius = 2e9 * km; }},
        {"planet.radius", [](Atmosphere& a) { a.bottom_radius = std::nan("") * km; }},
        {"planet.top = \"0 m\" is out of range: it must be above 0 m", [](Atmosphere& a) { a.top_altitude = 0.0 * m; }},
        {"planet.top", [](Atmosphere& a) { a.top_altitude = 7000.0 * km; }},
        {"ground.albedo = 1.5 (at 700 nm) is out of range: it must be from 0 to 1",
         [](Atmosphere& a) { a.ground_albedo = numbers(0.1, 1.5); }},
        {"ground.albedo = -0.1", [](Atmosphere& a) { a.ground_albedo = SpectrumOf<Number>::constant(-0.1); }},
        {"sun.angular_radius", [](Atmosphere& a) { a.sun.angular_radius = -0.001; }},
        {"sun.angular_radius", [](Atmosphere& a) { a.sun.angular_radius = 90.0 * deg; }},
        {"sun.irradiance = -1", [](Atmosphere& a) { a.sun.irradiance = SpectrumOf<SpectralIrradiance>::constant(-1.0 * W_per_m2_nm); }},
        {"sun.limb_darkening", [](Atmosphere& a) { a.sun.limb_darkening_1 = numbers(0.7, 1.1); }},
        {"constituent = 9 tables", [](Atmosphere& a) { a.constituents.resize(9); }},
        {"constituent.name = \"air\"", [](Atmosphere& a) { a.constituents[1].name = "air"; }},
        {"constituent.name = \"\"", [](Atmosphere& a) { a.constituents[1].name.clear(); }},
        {"haze.profile.scale_height = \"-1.2 km\" is out of range: it must be above 0 m",
         [](Atmosphere& a) { a.constituents[1].profile = ExponentialProfile{-1.2 * km}; }},
        {"haze.profile.top",
         [](Atmosphere& a) {
             a.constituents[1].profile = ExponentialProfile{1.2 * km, 0.0 * m};
         }},
        {"haze.profile.high",
         [](Atmosphere& a) {
             a.constituents[1].profile = LayerProfile{2.0 * km, 2.0 * km};
         }},
        {"ozone.profile.peak",
         [](Atmosphere& a) {
             a.constituents[2].profile = TriangleProfile{25.0 * km, 10.0 * km, 40.0 * km};
         }},
        {"ozone.profile.high",
         [](Atmosphere& a) {
             a.constituents[2].profile = TriangleProfile{10.0 * km, 25.0 * km, 25.0 * km};
         }},
        {"ozone.profile.density = -1 (at 1 km)",
         [](Atmosphere& a) {
             a.constituents[2].profile = TabulatedProfile{*Curve<Length, Number>::of({{0.0 * km, 1.0}, {1.0 * km, -1.0}})};
         }},
        {"ozone.profile.altitude_m = -1",
         [](Atmosphere& a) {
             a.constituents[2].profile = TabulatedProfile{*Curve<Length, Number>::of({{-1.0 * m, 1.0}, {1.0 * km, 1.0}})};
         }},
        {"air.scattering = -1e-05 is out of range: it must be 0 or more",
         [](Atmosphere& a) { a.constituents[0].scattering = coefficient(-1e-5); }},
        {"air.absorption = inf", [](Atmosphere& a) { a.constituents[0].absorption = coefficient(INFINITY); }},
        {"air.scattering.wavelength_nm = -1",
         [](Atmosphere& a) {
             a.constituents[0].scattering = *SpectrumOf<InverseLength>::of({{-1.0 * nm, 0.0 * per_m}, {1.0 * nm, 0.0 * per_m}});
         }},
        {"air.phase.depolarisation = 1", [](Atmosphere& a) { a.constituents[0].phase = RayleighPhase{1.0}; }},
        {"haze.phase.g = 1 ", [](Atmosphere& a) { a.constituents[1].phase = HenyeyGreensteinPhase{SpectrumOf<Number>::constant(1.0)}; }},
        {"haze.phase.g = -1 (at 400 nm)", [](Atmosphere& a) { a.constituents[1].phase = CornetteShanksPhase{numbers(-1.0, 0.0)}; }},
        {"haze.phase.value",
         [](Atmosphere& a) {
             a.constituents[1].phase = TabulatedPhase{{0.0, pi}, {550.0 * nm}, {{1.0, 1.0}}};
         }},
        {"haze.phase.value",
         [](Atmosphere& a) {
             a.constituents[1].phase = TabulatedPhase{{0.0, pi}, {550.0 * nm}, {{1.0}}};
         }},
    };
    for (const Case& c : cases) {
        CAPTURE(c.message);
        Atmosphere a = plain();
        c.spoil(a);
        const Result<Atmosphere> result = validated(a);
        REQUIRE(!result);
        CHECK(result.error().message().rfind(c.message, 0) == 0);
    }
}

TEST_CASE("an atmosphere covers the wavelengths at which all of it has data, and names what has none") {
    Atmosphere a = plain();
    CHECK(covers(a, 200.0 * nm, 3000.0 * nm));
    a.ground_albedo = numbers(0.1, 0.2);
    CHECK(covers(a, 400.0 * nm, 700.0 * nm));
    CHECK(covers(a, 400.0 * nm, 701.0 * nm).error().what.find("ground.albedo") == 0);
    a.constituents[0].scattering = *SpectrumOf<InverseLength>::of({{500.0 * nm, 1e-5 * per_m}, {600.0 * nm, 1e-5 * per_m}});
    CHECK(covers(a, 400.0 * nm, 600.0 * nm).error().message() ==
          "air.scattering has no data at every wavelength from 400 nm to 600 nm\n  It reaches from 500 nm to 600 nm.");
    a.constituents[1].phase = HenyeyGreensteinPhase{numbers(0.7, 0.8)};
    a.constituents[0] = plain().constituents[0];
    CHECK(covers(a, 399.0 * nm, 600.0 * nm).error().what.find("haze.phase") == 0);
}

TEST_CASE("the vertical optical depth is the integral of the extinction over altitude") {
    const Atmosphere a = plain();
    const Wavelength w = 550.0 * nm;
    const double closed = 1e-5 * 8000.0 * -std::expm1(-100.0 / 8.0) + 4e-5 * 1200.0 * -std::expm1(-100.0 / 1.2) + 1e-6 * 15000.0;
    CHECK(std::abs(optical_depth(a, w).value / closed - 1.0) < 1e-9);  // column_depth()'s stated error
    // The midpoint rule with 10 m steps: the curvature of the steepest profile gives (10/1200)^2 / 24 = 3e-6.
    double sum = 0.0;
    for (int i = 0; i < 10000; ++i) sum += extinction(a, (10.0 * i + 5.0) * m, w).value * 10.0;
    CHECK(std::abs(sum / closed - 1.0) < 4e-6);
    CHECK(extinction(a, 100.001 * km, w) == 0.0 * per_m);
    CHECK(scattering(a, 0.0 * m, w) == 4e-5 * per_m);
    CHECK(single_scattering_albedo(a.constituents[1], w) == 0.75);
    CHECK(optical_depth(scaled(a.constituents[1], 2.0), 100.0 * km, w).value ==
          2.0 * optical_depth(a.constituents[1], 100.0 * km, w).value);
}

TEST_CASE("model atmospheres: the air above a square metre weighs what the pressure says, and ozone is some 3 mm of gas") {
    // Surface pressure over the weight of a molecule: gravity varies by 0.3 % over the layer that holds the air.
    const double molecule_kg = 28.9644e-3 / 6.02214076e23;
    std::istringstream names{std::string(model_atmosphere_names)};
    for (std::string name; names >> name;) {
        CAPTURE(name);
        const auto levels = *model_atmosphere(name);
        const GasProfile air = gas_profile(levels, Gas::air);
        const double column = (air.reference.value * column_depth(air.profile, 120.0 * km).value);
        CHECK(std::abs(column * molecule_kg * 9.80 / (levels[0].pressure_hpa * 100.0) - 1.0) < 0.01);
        const GasProfile ozone = gas_profile(levels, Gas::ozone);
        const double dobson = ozone.reference.value * column_depth(ozone.profile, 120.0 * km).value / 2.6867e20;
        CHECK(dobson > 250.0);
        CHECK(dobson < 500.0);
        CHECK(effective_temperature_k(levels, Gas::ozone) > 210.0);
        CHECK(effective_temperature_k(levels, Gas::ozone) < 240.0);
    }
    CHECK(model_atmosphere("tropcal").error().remedy == "Did you mean \"tropical\"?");
}
