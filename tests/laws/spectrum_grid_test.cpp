// Wavelength grids, and the sun's spectrum.

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "spectrum/cie.h"
#include "spectrum/solar.h"
#include "spectrum/wavelength_grid.h"

using namespace airlight;

TEST_CASE("the standard grid has sixteen wavelengths from 360 to 830 nm") {
    const WavelengthGrid grid = WavelengthGrid::standard();
    CHECK(grid.size() == 16);
    CHECK(grid.first() == 360.0 * nm);
    CHECK(grid.last() == 830.0 * nm);
    CHECK(WavelengthGrid::of({grid.begin(), grid.end()}));  // its invariant holds
}

TEST_CASE("a uniform grid has its ends exactly and equal steps") {
    const WavelengthGrid grid = *WavelengthGrid::uniform(360.0 * nm, 720.0 * nm, 10);
    REQUIRE(grid.size() == 10);
    for (int i = 0; i < 10; ++i) CHECK(grid[i] == (360.0 + 40.0 * i) * nm);
    CHECK(WavelengthGrid::uniform(550.0 * nm, 550.0 * nm, 1)->size() == 1);
}

TEST_CASE("a grid's text reads back to the same grid") {
    for (const char* text : {"360:830:16", "450,550,650", "standard", "550", "380,780", "300.5,301,302.25", "333.3:777.7:4096"}) {
        CAPTURE(text);
        const Result<WavelengthGrid> grid = parse_wavelength_grid(text);
        REQUIRE(grid);
        CHECK(wavelength_grid_text(*grid) == text);
        CHECK(*parse_wavelength_grid(wavelength_grid_text(*grid)) == *grid);
    }
}

TEST_CASE("text that is no grid is refused with what is wrong") {
    const auto complaint = [](const char* text) {
        const Result<WavelengthGrid> grid = parse_wavelength_grid(text);
        return grid ? std::string("accepted") : grid.error().message();
    };
    CHECK(complaint("blue").starts_with("\"blue\" is not a wavelength in nm\n  Write wavelengths in nm"));
    CHECK(complaint("").starts_with("\"\" is not a wavelength"));
    CHECK(complaint("450,,650").starts_with("\"\" is not a wavelength"));
    CHECK(complaint("360:830").starts_with("\"360:830\" does not have first, last and count"));
    CHECK(complaint("360:830:0").starts_with("0 wavelengths are asked for"));
    CHECK(complaint("360:830:2.5").starts_with("2.5 wavelengths are asked for"));
    CHECK(complaint("360:830:1e99").starts_with("1e+99 wavelengths are asked for"));
    CHECK(complaint("360:830:1").starts_with("one wavelength cannot reach from 360 to 830 nm"));
    CHECK(complaint("830:360:16").find("does not lie above") != std::string::npos);
    CHECK(complaint("550,550").starts_with("550 nm does not lie above the wavelength before it, 550 nm"));
    CHECK(complaint("-550,550").starts_with("-550 nm is no wavelength of light"));
    CHECK(complaint("0.55").starts_with("0.55 nm is no wavelength of light"));  // micrometres were meant
    CHECK(complaint("nan").find("accepted") == std::string::npos);
    CHECK(!WavelengthGrid::of({}));
    CHECK(!WavelengthGrid::of({std::numeric_limits<double>::quiet_NaN() * nm}));
    CHECK(!WavelengthGrid::of(std::vector<Wavelength>(5000, 550.0 * nm)));
}

TEST_CASE("the sun sends 740 W m-2 between 360 and 830 nm (ASTM G173)") {
    const SpectrumOf<SpectralIrradiance> sun = solar_irradiance();
    double sum = 0.0;
    for (double w = 360.0; w <= 830.0; w += 5.0) sum += 5.0 * sun.at(w * nm).value;
    CHECK(std::abs(sum - 740.0) <= 0.5);  // the printed digit
}

TEST_CASE("sunlight thins with the square of the distance") {
    const double near = solar_irradiance(0.9833).at(550.0 * nm).value;
    const double far = solar_irradiance(1.0167).at(550.0 * nm).value;
    CHECK(std::abs(near / far - (1.0167 * 1.0167) / (0.9833 * 0.9833)) < 1e-14);
    CHECK(solar_irradiance(1.0).at(550.0 * nm) == 1.8648 * W_per_m2_nm);
}

TEST_CASE("the sun lights a plane above the atmosphere with some 133 thousand lux") {
    // Darula, Kittler and Gueymard 2005 (Solar Energy 79, 559): 133.8 klx, 133.3 to 134.1 among published spectra.
    CHECK(std::abs(illuminance(solar_irradiance()) / 133.8e3 - 1.0) < 0.01);
}
