// Quantities: dimensions, units in text, and the exponential that spectra use.

#include <doctest/doctest.h>

#include <random>

#include "units/curve.h"
#include "units/spectral.h"
#include "units/text.h"
#include "units/units.h"

using namespace airlight;

TEST_CASE("products and roots carry their dimension") {
    static_assert(std::is_same_v<decltype(1.0 * m * m), Area>);
    static_assert(std::is_same_v<decltype(sqrt(1.0 * m2)), Length>);
    static_assert(std::is_same_v<decltype(1.0 / (1.0 * m)), InverseLength>);
    static_assert(!std::is_convertible_v<double, Length>);
    static_assert(std::is_convertible_v<double, Number>);
    CHECK((8.0 * km).in(m) == 8000.0);
    CHECK(sqrt(9.0 * m2) == 3.0 * m);
}

TEST_CASE("a length in text reads to the same length in any unit") {
    CHECK(*parse_length("8 km") == 8000.0 * m);
    CHECK(*parse_length("  -1200m ") == -1200.0 * m);
    CHECK(*parse_length("+1e3 m") == 1.0 * km);
    CHECK(*parse_length("1 mi") == 1609.344 * m);
    CHECK(*parse_angle("180 deg") == pi);
    CHECK(*parse_wavelength("0.55 um") == 550.0 * nm);
    CHECK(*parse_inverse_length("0.1 1/km") == 1e-4 * per_m);
}

TEST_CASE("text that is no quantity is refused with the units that would be one") {
    for (const char* text : {"", "8", "km", "8 deg", "nan m", "inf km", "8 km 3", "1e999 m"}) {
        CAPTURE(text);
        const Result<Length> length = parse_length(text);
        REQUIRE(!length);
        CHECK(length.error().message().find("m, km") != std::string::npos);
    }
}

TEST_CASE("a written quantity reads back to the same bits") {
    std::mt19937_64 random(20260101);
    std::uniform_real_distribution<double> exponent(-3.0, 8.0);
    for (int i = 0; i < 2000; ++i) {
        const Length length = std::pow(10.0, exponent(random)) * m;
        CHECK(*parse_length(length_text(length)) == length);
        const double angle = length.value * 1e-7;
        CHECK(*parse_angle(angle_text(angle)) == angle);
    }
    CHECK(length_text(8.0 * km) == "8 km");
    CHECK(length_text(250.0 * m) == "250 m");
    CHECK(angle_text(35.0 * deg) == "35 deg");
}

TEST_CASE("the exponential of spectra agrees with the library's to its stated error") {
    double worst_double = 0.0;
    double worst_float = 0.0;
    for (double x = -700.0; x < 700.0; x += 0.0137) {
        worst_double = std::max(worst_double, std::abs(fast_exp(x) / std::exp(x) - 1.0));
        if (std::abs(x) < 87.0)
            worst_float = std::max(worst_float,
                                   std::abs(fast_exp(static_cast<float>(x)) / std::exp(static_cast<double>(static_cast<float>(x))) - 1.0));
    }
    CHECK(worst_double < 3e-16 + 2.3e-16);  // its own error and half a unit in the last place of the library's
    CHECK(worst_float < 2.0e-7);
    CHECK(fast_exp(-1e4f) == 0.0f);
    CHECK(fast_exp(-1e4) == 0.0);
    CHECK(fast_exp(0.0) == 1.0);
}

TEST_CASE("the logarithm of spectra agrees with the library's to its stated error") {
    double worst = 0.0;
    for (double x = -86.0; x < 88.0; x += 0.00137) {
        const auto number = static_cast<float>(std::exp(x));
        const double exact = std::log(static_cast<double>(number));
        worst = std::max(worst, std::abs(static_cast<double>(fast_log(number)) - exact) / (1.0 + std::abs(exact)));
    }
    CHECK(worst < 2e-7);
    CHECK(fast_log(1.0f) == 0.0f);
}

TEST_CASE("a curve is linear between its samples, and its mean is its integral over the width") {
    using C = Curve<Wavelength, Number>;
    const C curve = *C::of({{400.0 * nm, 1.0}, {500.0 * nm, 3.0}, {600.0 * nm, 1.0}});
    CHECK(curve.at(450.0 * nm) == 2.0);
    CHECK(curve.at(300.0 * nm) == 1.0);
    CHECK(curve.mean(400.0 * nm, 600.0 * nm) == 2.0);
    CHECK(std::abs(curve.mean(450.0 * nm, 550.0 * nm).value - 2.5) < 1e-15);
    CHECK(curve.mean(450.0 * nm, 450.0 * nm) == 2.0);
    CHECK(curve.covers(400.0 * nm, 600.0 * nm));
    CHECK(!curve.covers(399.0 * nm, 600.0 * nm));
    CHECK(C::constant(7.0).covers(1.0 * nm, 1e9 * nm));
    CHECK(!C::of({}));
    CHECK(!C::of({{500.0 * nm, 1.0}, {500.0 * nm, 3.0}}));
    CHECK(!C::of({{500.0 * nm, std::nan("")}}));
}
