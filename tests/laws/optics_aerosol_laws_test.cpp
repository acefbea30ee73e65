// Aerosol from visibilities, turbidities and optical depths: inverses, limits, and two readings of one turbidity.

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

#include "optics/aerosol_laws.h"
#include "optics/rayleigh.h"

using namespace airlight;

namespace {

constexpr Wavelength green = 550.0 * nm;

}  // namespace

TEST_CASE("Angstrom's law through two optical depths passes through them") {
    const AngstromLaw law = angstrom_law(440.0 * nm, 0.3, 870.0 * nm, 0.12);
    CHECK(optical_depth(law, 440.0 * nm) == doctest::Approx(0.3).epsilon(1e-14));
    CHECK(optical_depth(law, 870.0 * nm) == doctest::Approx(0.12).epsilon(1e-14));
    CHECK(optical_depth({0.1, 1.3}, 1000.0 * nm) == doctest::Approx(0.1).epsilon(1e-15));
    CHECK(angstrom_factor(law.alpha, 440.0 * nm, 870.0 * nm) == doctest::Approx(0.4).epsilon(1e-14));
    CHECK(angstrom_factor(0.0, 440.0 * nm, 870.0 * nm) == 1.0);
}

TEST_CASE("Koschmieder: at the visibility a black object keeps the threshold's contrast, and visibility and extinction are inverse") {
    for (const double contrast : {range_contrast, optical_range_contrast}) {
        const InverseLength extinction = extinction_of_visibility(10.0 * km, contrast);
        CHECK(std::exp(-(extinction * (10.0 * km)).value) == doctest::Approx(contrast).epsilon(1e-14));
        CHECK(visibility_of_extinction(extinction, contrast).in(km) == doctest::Approx(10.0).epsilon(1e-14));
    }
    CHECK((extinction_of_visibility(1.0 * km, range_contrast) * (1.0 * km)).value == doctest::Approx(3.912).epsilon(1e-4));
    CHECK((extinction_of_visibility(1.0 * km, optical_range_contrast) * (1.0 * km)).value == doctest::Approx(2.996).epsilon(1e-4));
}

TEST_CASE("the aerosol has what the molecules leave of the extinction, and one cannot see further than in pure air") {
    const InverseLength molecular = rayleigh_cross_section_of_air(green) * standard_number_density;
    const InverseLength aerosol = *aerosol_extinction_of_visibility(20.0 * km, molecular, range_contrast);
    CHECK(visibility_of_extinction(aerosol + molecular, range_contrast).in(km) == doctest::Approx(20.0).epsilon(1e-14));
    const Result<InverseLength> beyond = aerosol_extinction_of_visibility(500.0 * km, molecular, range_contrast);
    REQUIRE(!beyond);
    // Pure air at 288.15 K: 3.912 / (0.01149 / km) = 340.5 km.
    CHECK(beyond.error().message().find("one sees 341 km") != std::string::npos);
    CHECK(!aerosol_extinction_of_visibility(0.0 * m, molecular, range_contrast));
}

TEST_CASE("a turbidity of one is air without aerosol, and turbidity and optical depth are inverse") {
    CHECK(aerosol_depth_of_turbidity(1.0, 0.0971) == 0.0);
    CHECK(turbidity_of_aerosol_depth(aerosol_depth_of_turbidity(3.7, 0.0971), 0.0971) == doctest::Approx(3.7).epsilon(1e-15));
    // Preetham's law leaves 5e-4 at T = 1.
    CHECK(std::abs(optical_depth(preetham_angstrom_law(1.0), green)) < 1e-3);
}

TEST_CASE("Preetham's Angstrom law and his haze of scale height 1.25 km are two readings of the same turbidity") {
    for (const double turbidity : {2.0, 4.0, 8.0}) {
        const double molecular = rayleigh_optical_depth(green);
        const double law = optical_depth(preetham_angstrom_law(turbidity), green);
        const double haze = (preetham_haze_scattering(turbidity, green) * (1.25 * km)).value;
        // Fits of two authors to measurements: within 5 % of each other and of the definition of turbidity.
        CHECK(turbidity_of_aerosol_depth(law, molecular) == doctest::Approx(turbidity).epsilon(0.05));
        CHECK(haze == doctest::Approx(law).epsilon(0.05));
    }
}
