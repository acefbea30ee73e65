// Absorbing gases: the tables, their bands and their temperatures.

#include <doctest/doctest.h>

#include <cmath>

#include "optics/gases.h"

using namespace airlight;

TEST_CASE("the cross-section of ozone is the published one at the temperatures and bands of its table") {
    CHECK(ozone_cross_section(203.0).at(300.0 * nm).in(m2) == doctest::Approx(3.5838e-23).epsilon(1e-12));
    CHECK(ozone_cross_section(293.0).at(385.0 * nm).in(m2) == doctest::Approx(1.1126e-27).epsilon(1e-12));
    CHECK(ozone_cross_section(243.0).at(550.0 * nm).in(m2) == doctest::Approx(3.3905e-25).epsilon(1e-12));
    CHECK(ozone_cross_section(223.0).covers(300.0 * nm, 830.0 * nm));
    CHECK(!ozone_cross_section(223.0).covers(299.0 * nm, 830.0 * nm));
}

TEST_CASE("the cross-section of nitrogen dioxide is the published one at the temperatures and bands of its table") {
    CHECK(nitrogen_dioxide_cross_section(223.0).at(300.0 * nm).in(m2) == doctest::Approx(1.2187e-23).epsilon(1e-12));
    CHECK(nitrogen_dioxide_cross_section(273.0).at(305.0 * nm).in(m2) == doctest::Approx(1.6585e-23).epsilon(1e-12));
    CHECK(nitrogen_dioxide_cross_section(293.0).at(310.0 * nm).in(m2) == doctest::Approx(1.8991e-23).epsilon(1e-12));
    CHECK(nitrogen_dioxide_cross_section(250.0).covers(300.0 * nm, 830.0 * nm));
    CHECK(nitrogen_dioxide_cross_section(250.0).at(800.0 * nm).in(m2) == 0.0);
}

TEST_CASE("between two measured temperatures a cross-section is linear, beyond them it is the last one's") {
    const double cold = ozone_cross_section(243.0).at(600.0 * nm).value;
    const double warm = ozone_cross_section(273.0).at(600.0 * nm).value;
    CHECK(ozone_cross_section(253.0).at(600.0 * nm).value == doctest::Approx(cold * 2.0 / 3.0 + warm / 3.0).epsilon(1e-14));
    CHECK(ozone_cross_section(180.0) == ozone_cross_section(203.0));
    CHECK(ozone_cross_section(310.0) == ozone_cross_section(293.0));
}

TEST_CASE("ozone absorbs most of the visible near 600 nm, nitrogen dioxide near 400 nm") {
    const auto peak = [](const SpectrumOf<Area>& spectrum) {
        Wavelength best = 350.0 * nm;
        for (double w = 350.0; w <= 830.0; w += 5.0)
            if (spectrum.at(w * nm) > spectrum.at(best)) best = w * nm;
        return best.in(nm);
    };
    CHECK(std::abs(peak(ozone_cross_section(223.0)) - 602.0) < 5.0);  // the Chappuis band
    CHECK(std::abs(peak(nitrogen_dioxide_cross_section(223.0)) - 400.0) < 20.0);
    // 300 Dobson units (2.687e20 molecules a square metre each) take 2.7 % of the light at 550 nm.
    CHECK(ozone_cross_section(223.0).at(550.0 * nm).in(m2)*300.0 * 2.687e20 == doctest::Approx(0.0274).epsilon(0.01));
}
