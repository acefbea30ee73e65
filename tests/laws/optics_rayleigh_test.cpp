// Scattering by molecules: laws, limits and the values printed by its sources.

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

#include "optics/rayleigh.h"

using namespace airlight;

namespace {

// Bodhaine's own fit to the optical depth at sea level, 45 degrees of latitude and 360 ppm, good to 0.01 % over 250 to 850 nm. [Bodhaine1999, eq. 30]
double fitted_optical_depth(Wavelength wavelength) {
    const double s = std::pow(1000.0 / wavelength.in(nm), 2);
    return 0.0021520 * (1.0455996 - 341.29061 * s - 0.90230850 / s) / (1.0 + 0.0027059889 * s - 85.968563 / s);
}

double to_digits(double x, int decimals) { return std::round(x * std::pow(10.0, decimals)) / std::pow(10.0, decimals); }

}  // namespace

TEST_CASE("the optical depth of the standard atmosphere is Bodhaine's to all printed digits") {
    CHECK(to_digits(rayleigh_optical_depth(400.0 * nm), 4) == 0.3602);
    CHECK(to_digits(rayleigh_optical_depth(500.0 * nm), 4) == 0.1434);
    CHECK(to_digits(rayleigh_optical_depth(550.0 * nm), 4) == 0.0971);
    CHECK(to_digits(rayleigh_optical_depth(600.0 * nm), 4) == 0.0681);
}

TEST_CASE("the optical depth from refractive index and gravity agrees with Bodhaine's fit from 250 to 850 nm") {
    for (double w = 250.0; w <= 850.0; w += 10.0) {
        CAPTURE(w);
        // 1e-4 for the fit of the cross-section and 1e-4 for the five digits of its column, 0.0021520.
        CHECK(rayleigh_optical_depth(w * nm) == doctest::Approx(fitted_optical_depth(w * nm)).epsilon(2e-4));
    }
}

TEST_CASE("the cross-section of air is the one that an independent program prints") {
    // colour-science 0.4, scattering_cross_section at 555 nm and 300 ppm: 4.6613309e-27 cm2.
    CHECK(rayleigh_cross_section_of_air(555.0 * nm, 300.0).in(cm2) == doctest::Approx(4.6613309e-27).epsilon(1e-5));
}

TEST_CASE("the optical depth follows the pressure, and grows where gravity is weak") {
    const double standard = rayleigh_optical_depth(550.0 * nm);
    CHECK(rayleigh_optical_depth(550.0 * nm, {.pressure_pa = 50662.5}) == doctest::Approx(0.5 * standard).epsilon(1e-14));
    // From equator to pole gravity grows by 0.53 %.
    const double ratio =
        rayleigh_optical_depth(550.0 * nm, {.latitude = 0.0}) / rayleigh_optical_depth(550.0 * nm, {.latitude = 90.0 * deg});
    CHECK(ratio == doctest::Approx(1.0053).epsilon(1e-4));
    CHECK(rayleigh_optical_depth(550.0 * nm, {.altitude = 3400.0 * m}) > standard);  // the same pressure weighs less higher up
}

TEST_CASE("the column at sea level holds 2.152e25 molecules per square centimetre and the air of 8.4 km at the ground") {
    CHECK(molecules_per_m2({}) == doctest::Approx(2.1520e29).epsilon(1e-4));  // [Bodhaine1999, eq. 30]
    CHECK(molecules_per_m2({}) / standard_number_density.in(per_m3) == doctest::Approx(8450.0).epsilon(2e-3));
}

TEST_CASE("the simple form of graphics is the full one without King's factor, to the order of n - 1") {
    for (const double w : {400.0, 550.0, 700.0}) {
        const double n = refractive_index_of_air(w * nm);
        const InverseLength full = rayleigh_cross_section(n, standard_number_density, 1.0, w * nm) * standard_number_density;
        // (n^2 + 2)^2 / 9 = 1 + (4/3)(n - 1) + ..., 4e-4 at most.
        CHECK((simple_rayleigh_scattering(n, standard_number_density, w * nm) / full).value ==
              doctest::Approx(1.0 + 4.0 / 3.0 * (n - 1.0)).epsilon(1e-7));
    }
}

TEST_CASE("for a fixed index the cross-section falls with the fourth power of the wavelength and the square of the density") {
    const auto sigma = [](double density, double wavelength) {
        return rayleigh_cross_section(1.0003, density * per_m3, 1.05, wavelength * nm).value;
    };
    CHECK(sigma(2.5e25, 400.0) / sigma(2.5e25, 800.0) == doctest::Approx(16.0).epsilon(1e-13));
    CHECK(sigma(1.0e25, 400.0) / sigma(2.0e25, 400.0) == doctest::Approx(4.0).epsilon(1e-13));
}

TEST_CASE("King's factor and the depolarisation ratio undo each other") {
    for (const double rho : {0.0, 0.0279, 0.1, 0.5})
        CHECK(depolarisation((6.0 + 3.0 * rho) / (6.0 - 7.0 * rho)) == doctest::Approx(rho).epsilon(1e-13));
    // Bates' air at 550 nm: 1.0485, a depolarisation of 0.0283 (the 0.0279 of Young 1980 is within his scatter). [Bodhaine1999, table 2]
    CHECK(king_factor_of_air(550.0 * nm) == doctest::Approx(1.0485).epsilon(2e-4));
    CHECK(depolarisation(king_factor_of_air(550.0 * nm)) == doctest::Approx(0.0279).epsilon(0.03));
}

TEST_CASE("the refractive index of dry air is 1.0002778 at 550 nm and grows with carbon dioxide") {
    CHECK(refractive_index_of_air(550.0 * nm, 300.0) - 1.0 == doctest::Approx(2.7782e-4).epsilon(2e-5));
    const double more = (refractive_index_of_air(550.0 * nm, 1e6) - 1.0) / (refractive_index_of_air(550.0 * nm, 0.0) - 1.0);
    // All carbon dioxide: by this law 1.54 times air, which is what the index of the pure gas says within 1 %.
    CHECK(more == doctest::Approx(1.54).epsilon(1e-3));
    CHECK((refractive_index_of_carbon_dioxide(550.0 * nm) - 1.0) / (refractive_index_of_air(550.0 * nm, 0.0) - 1.0) ==
          doctest::Approx(more).epsilon(0.01));
}

TEST_CASE("carbon dioxide has the refractivity of Kaye and Laby's tables and scatters more than twice as much as air") {
    // 449e-6 at 589.3 nm, 0 C and 101325 Pa; at 15 C by the ratio of densities. Three digits.
    CHECK(refractive_index_of_carbon_dioxide(589.3 * nm) - 1.0 == doctest::Approx(449e-6 * 273.15 / 288.15).epsilon(2e-3));
    const double ratio = (rayleigh_cross_section_of_carbon_dioxide(550.0 * nm) / rayleigh_cross_section_of_air(550.0 * nm)).value;
    CHECK(ratio > 2.2);
    CHECK(ratio < 2.8);
}
