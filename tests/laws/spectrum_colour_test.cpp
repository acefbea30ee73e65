// Colour: the standard observer, displays, adaptation, and colour from few wavelengths.

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "spectrum/colour.h"
#include "spectrum/colour_temperature.h"
#include "spectrum/colour_weights.h"
#include "spectrum/solar.h"

using namespace airlight;

namespace {

bool near(double a, double b, double bound) { return std::abs(a - b) <= bound; }
bool near(Rgb a, Rgb b, double bound) { return near(a.r, b.r, bound) && near(a.g, b.g, bound) && near(a.b, b.b, bound); }

}  // namespace

TEST_CASE("light of equal energy at all wavelengths is near x = y = 1/3") {
    // The functions are normalised for this; the 5 nm table, printed to 4 digits in its tails, reaches it to 5e-5.
    const Chromaticity c = chromaticity(to_xyz(SpectrumOf<SpectralRadiance>::constant(1.0 * W_per_m2_sr_nm)));
    CHECK(near(c.x, 1.0 / 3.0, 5e-5));
    CHECK(near(c.y, 1.0 / 3.0, 5e-5));
}

TEST_CASE("one watt at 555 nm is 683 lumens") {
    // A triangle of area 1 W that only one band sees.
    const auto line = *SpectrumOf<SpectralIrradiance>::of(
        {{550.0 * nm, 0.0 * W_per_m2_nm}, {555.0 * nm, 0.2 * W_per_m2_nm}, {560.0 * nm, 0.0 * W_per_m2_nm}});
    CHECK(near(illuminance(line), 683.0, 1e-9));
}

TEST_CASE("sRGB's matrix is the published one") {
    // IEC 61966-2-1, rows of linear RGB from XYZ, printed to four digits; derived there from rounded inverses.
    const double rows[3][3] = {{3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}};
    const RgbConverter srgb(RgbSpace::srgb, WhitePoint::d65);
    for (int column = 0; column < 3; ++column) {
        const Rgb rgb = srgb.to_rgb({column == 0 ? 1.0 : 0.0, column == 1 ? 1.0 : 0.0, column == 2 ? 1.0 : 0.0});
        CHECK(near(rgb, {rows[0][column], rows[1][column], rows[2][column]}, 4e-4));
    }
}

TEST_CASE("luminance weights are the published ones") {
    // sRGB: 0.2126, 0.7152, 0.0722. Rec.2020: 0.2627, 0.6780, 0.0593. ACEScg: 0.2722287, 0.6740818, 0.0536895.
    const auto weights = [](RgbSpace space, WhitePoint white) {
        const RgbConverter c(space, white);
        return Rgb{c.luminance({1, 0, 0}), c.luminance({0, 1, 0}), c.luminance({0, 0, 1})};
    };
    CHECK(near(weights(RgbSpace::srgb, WhitePoint::d65), {0.2126, 0.7152, 0.0722}, 5e-5));
    CHECK(near(weights(RgbSpace::rec2020, WhitePoint::d65), {0.2627, 0.6780, 0.0593}, 5e-5));
    CHECK(near(weights(RgbSpace::acescg, WhitePoint::d60), {0.2722287, 0.6740818, 0.0536895}, 5e-7));
}

TEST_CASE("light of the chosen white point has equal primaries, as much as its luminance") {
    for (const RgbSpace space : {RgbSpace::srgb, RgbSpace::rec2020, RgbSpace::acescg})
        for (const WhitePoint white : {WhitePoint::d65, WhitePoint::d60, WhitePoint::e, WhitePoint::sun}) {
            CAPTURE(name_of(space));
            CAPTURE(name_of(white));
            const Rgb rgb = RgbConverter(space, white).to_rgb(with_luminance(white_chromaticity(white), 3000.0));
            CHECK(near(rgb, {3000.0, 3000.0, 3000.0}, 1e-9));
        }
}

TEST_CASE("a colour survives the way to each RGB space and back") {
    std::mt19937_64 random(20260102);
    std::uniform_real_distribution<double> amount(0.0, 1e4);
    for (const RgbSpace space : {RgbSpace::srgb, RgbSpace::rec2020, RgbSpace::acescg})
        for (const WhitePoint white : {WhitePoint::d65, WhitePoint::d60, WhitePoint::e, WhitePoint::sun}) {
            const RgbConverter converter(space, white);
            for (int i = 0; i < 50; ++i) {
                const Xyz colour{amount(random), amount(random), amount(random)};
                const Xyz back = converter.to_xyz(converter.to_rgb(colour));
                CHECK(near(back.x, colour.x, 1e-9));
                CHECK(near(back.y, colour.y, 1e-9));
                CHECK(near(back.z, colour.z, 1e-9));
            }
        }
}

TEST_CASE("Bradford's adaptation from D65 to D50 is the published matrix") {
    // Lindbloom, "Chromatic Adaptation" (2017), printed to seven digits for whites printed to five.
    const double rows[3][3] = {{1.0478112, 0.0228866, -0.0501270}, {0.0295424, 0.9904844, -0.0170491}, {-0.0092345, 0.0150436, 0.7521316}};
    const glm::dmat3 matrix = adaptation(chromaticity({0.95047, 1.0, 1.08883}), chromaticity({0.96422, 1.0, 0.82521}));
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) CHECK(near(matrix[column][row], rows[row][column], 2e-7));
}

TEST_CASE("adaptation to the same white changes nothing, and to and back is the identity") {
    const Chromaticity a = white_chromaticity(WhitePoint::d65), b = white_chromaticity(WhitePoint::sun);
    const glm::dmat3 round_trip = adaptation(b, a) * adaptation(a, b), none = adaptation(a, a);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            CHECK(near(round_trip[i][j], i == j, 1e-14));
            CHECK(near(none[i][j], i == j, 1e-14));
        }
}

TEST_CASE("a colour outside of the gamut keeps its luminance and its hue, and loses only saturation") {
    const RgbConverter srgb(RgbSpace::srgb, WhitePoint::d65);
    const Rgb spectral_blue{-50.0, 20.0, 900.0};
    const Rgb shown = srgb.into_gamut(spectral_blue);
    CHECK(near(srgb.luminance(shown), srgb.luminance(spectral_blue), 1e-10));
    CHECK(shown.r == 0.0);
    CHECK(shown.g > 0.0);
    // On the line between grey and the colour: differences of amounts keep their ratio.
    CHECK(near((shown.b - shown.g) / (shown.g - shown.r), (900.0 - 20.0) / (20.0 + 50.0), 1e-10));
    CHECK(near(srgb.into_gamut({1.0, 2.0, 3.0}), {1.0, 2.0, 3.0}, 0.0));
    CHECK(near(srgb.into_gamut({-1.0, -2.0, 3.0}), {0.0, 0.0, 0.0}, 0.0));
}

TEST_CASE("a name of a space or a white reads back to it") {
    for (const RgbSpace space : {RgbSpace::srgb, RgbSpace::rec2020, RgbSpace::acescg}) CHECK(rgb_space_named(name_of(space)) == space);
    for (const WhitePoint white : {WhitePoint::d65, WhitePoint::d60, WhitePoint::e, WhitePoint::sun})
        CHECK(white_point_named(name_of(white)) == white);
    CHECK(!rgb_space_named("xyz"));
    CHECK(!white_point_named("d65"));
}

TEST_CASE("sRGB's transfer function has its published values and its inverse") {
    CHECK(near(srgb_encoded(0.18), 0.46135612950044164, 1e-12));
    CHECK(srgb_encoded(0.0) == 0.0);
    CHECK(srgb_encoded(1.0) == 1.0);
    CHECK(near(srgb_encoded(0.0031308), srgb_encoded(0.00313081), 1e-6));
    for (int i = 0; i <= 1000; ++i)
        CHECK(near(srgb_linear(srgb_encoded(i / 1000.0)), i / 1000.0, 1e-7));  // the published joints differ by 1e-7
}

TEST_CASE("a black body has its own temperature, of standard illuminants the published one") {
    for (const double kelvin : {1500.0, 2856.0, 5772.0, 10000.0, 40000.0}) {
        const auto found = correlated_colour_temperature(black_body_colour(kelvin));
        REQUIRE(found);
        CHECK(near(found->kelvin / kelvin, 1.0, 1e-5));
        CHECK(near(found->distance, 0.0, 1e-7));
    }
    // CIE 015:2018: D65 6503 K (6500 times 1.4388 / 1.4380), illuminant A 2856 K (2855.5), D50 5002 K.
    CHECK(near(correlated_colour_temperature(with_luminance({0.31272, 0.32903}, 1.0))->kelvin, 6503.6, 3.0));
    CHECK(near(correlated_colour_temperature(with_luminance({0.44758, 0.40745}, 1.0))->kelvin, 2855.5, 2.0));
    CHECK(near(correlated_colour_temperature(with_luminance({0.34567, 0.35851}, 1.0))->kelvin, 5002.0, 3.0));
    CHECK(correlated_colour_temperature(with_luminance({0.31272, 0.32903}, 1.0))->distance > 0.003);
}

TEST_CASE("what is bluer than any black body, purple or black has no colour temperature") {
    CHECK(!correlated_colour_temperature(with_luminance({0.20, 0.18}, 1.0)));
    CHECK(!correlated_colour_temperature(with_luminance({0.35, 0.15}, 1.0)));
    CHECK(!correlated_colour_temperature({0.0, 0.0, 0.0}));
}

TEST_CASE("the sun above the atmosphere is a little warmer than D65") {
    const auto sun = correlated_colour_temperature(to_xyz(solar_irradiance()));
    REQUIRE(sun);
    CHECK(sun->kelvin > 5700.0);
    CHECK(sun->kelvin < 6100.0);
}

namespace {

// Ozone's absorption cross-section at 223 K, means over 5 nm from 360 to 830 nm, in 1e-26 m2 (Bogumil et al. 2003).
constexpr double ozone[95] = {
    0.2504, 0.06165, 0.03791, 0.02716, 0.02858, 0.03876, 0.05669, 0.09189, 0.1122, 0.1548, 0.2557, 0.2906, 0.3922, 0.663, 0.6866, 0.8798,
    1.379,  1.63,    1.838,   2.166,   3.663,   3.632,   4.071,   4.738,   7.54,   8.098,  8.119,  9.067,  12.16,  16.13, 15.82,  16.7,
    18.48,  22.01,   26.72,   28.7,    29.53,   32.17,   33.94,   35.95,   39.93,  44.27,  47.27,  48.71,  47.01,  45.22, 45.29,  48.28,
    52.25,  52.3,    48.61,   44.41,   41.22,   38.78,   36.15,   33.36,   30.3,   27.6,   25.37,  23.32,  21.32,  19.38, 17.24,  15.33,
    13.77,  12.67,   11.25,   9.793,   8.57,    7.747,   7.209,   6.944,   6.198,  5.331,  4.682,  4.334,  4.26,   4.484, 4.302,  3.326,
    2.776,  2.553,   2.568,   2.977,   3.302,   2.662,   2.076,   1.705,   1.531,  1.522,  1.864,  2.29,   2.147,  1.452, 0.9593};

// What air does to sunlight: how much of it is scattered towards the eye, and what is left of that on the way.
struct Light {
    double scattered;  // exponent of (550 nm / wavelength): 4 for blue sky, 1.3 for haze, 0 for the sun itself
    double air_mass;   // through air (optical depth 0.0971 at 550 nm) and haze (0.1)
    double ozone;      // through ozone (300 DU)
    bool leaves;       // reflected by green leaves: a bump at 550 nm and the red edge at 718 nm

    SpectrumOf<SpectralIrradiance> times(const SpectrumOf<SpectralIrradiance>& sun) const {
        std::vector<SpectrumOf<SpectralIrradiance>::Sample> samples;
        for (int i = 0; i < 95; ++i) {
            const double w = 360.0 + 5.0 * i;
            const double depth = air_mass * (0.0971 * std::pow(550.0 / w, 4.08) + 0.1 * std::pow(550.0 / w, 1.3)) +
                                 ozone * 300 * 2.687e20 * 1e-26 * ::ozone[i];
            const double reflected = 0.03 + 0.08 * std::exp(-std::pow((w - 550.0) / 30.0, 2)) + 0.45 / (1.0 + std::exp((718.0 - w) / 10.0));
            samples.push_back({w * nm, (leaves ? reflected : std::pow(550.0 / w, scattered)) * std::exp(-depth) * sun.at(w * nm)});
        }
        return *SpectrumOf<SpectralIrradiance>::of(std::move(samples));
    }
};

struct ColourError {
    double luminance = 0.0, chromaticity = 0.0;
};

// The largest errors of colour from `grid` over blue skies, hazes and suns (or over leaves), high and setting, under much and
// no ozone.
ColourError worst_error(const WavelengthGrid& grid, bool leaves = false) {
    const SpectrumOf<SpectralIrradiance> sun = solar_irradiance();
    const ColourWeights weights(grid, sun);
    ColourError worst;
    for (const double scattered : {4.0, 1.3, 0.0})
        for (const double air_mass : {0.0, 1.0, 3.0, 10.0, 38.0})
            for (const double ozone_mass : {0.0, 1.0, 5.0, 12.0}) {
                const auto light = Light{scattered, air_mass, ozone_mass, leaves}.times(sun);
                std::vector<double> samples;
                for (const Wavelength w : grid) samples.push_back(light.at(w).value);
                const Xyz exact = to_xyz(light), found = weights.to_xyz(std::span<const double>(samples));
                worst.luminance = std::max(worst.luminance, std::abs(found.y / exact.y - 1.0));
                worst.chromaticity = std::max(worst.chromaticity, distance(uniform_chromaticity(found), uniform_chromaticity(exact)));
            }
    return worst;
}

}  // namespace

TEST_CASE("sixteen wavelengths give the colour of any sky within 0.3 % of luminance and 0.002 in u'v'") {
    const ColourError standard = worst_error(WavelengthGrid::standard());
    MESSAGE("standard grid: luminance within " << 100.0 * standard.luminance << " %, u'v' within " << standard.chromaticity);
    CHECK(standard.luminance <= 0.003);
    CHECK(standard.chromaticity <= 0.002);
    const ColourError uniform = worst_error(*WavelengthGrid::uniform(360.0 * nm, 830.0 * nm, 16));
    MESSAGE("360:830:16: luminance within " << 100.0 * uniform.luminance << " %, u'v' within " << uniform.chromaticity);
    CHECK(standard.luminance < uniform.luminance);
}

TEST_CASE("sixteen wavelengths give the colour of leaves within 0.5 % even under a setting sun") {
    const ColourError error = worst_error(WavelengthGrid::standard(), true);
    MESSAGE("leaves: luminance within " << 100.0 * error.luminance << " %, u'v' within " << error.chromaticity);
    CHECK(error.luminance <= 0.005);
    CHECK(error.chromaticity <= 0.002);
}

TEST_CASE("forty wavelengths from 360 to 830 nm give the colour of any sky within 0.1 % and 0.0002") {
    const ColourError error = worst_error(*WavelengthGrid::uniform(360.0 * nm, 830.0 * nm, 40));
    CHECK(error.luminance <= 0.001);
    CHECK(error.chromaticity <= 0.0002);
}

TEST_CASE("weights at each 5 nm are the colour-matching functions themselves") {
    const SpectrumOf<SpectralIrradiance> sun = solar_irradiance();
    const ColourWeights weights(*WavelengthGrid::uniform(360.0 * nm, 830.0 * nm, 95), sun);
    for (std::size_t i = 0; i < 95; ++i) CHECK(near(weights.weights()[i].y, 683.0 * 5.0 * cie1931()[i].y, 1e-9));
}

TEST_CASE("sunlight itself has its exact colour on any grid, even one wavelength") {
    const SpectrumOf<SpectralIrradiance> sun = solar_irradiance();
    for (const char* text : {"standard", "550", "450,650", "400:700:7"}) {
        CAPTURE(text);
        const WavelengthGrid grid = *parse_wavelength_grid(text);
        std::vector<double> samples;
        for (const Wavelength w : grid) samples.push_back(sun.at(w).value);
        const Xyz found = ColourWeights(grid, sun).to_xyz(std::span<const double>(samples)), exact = to_xyz(sun);
        CHECK(near(found.x / exact.x, 1.0, 1e-13));
        CHECK(near(found.y / exact.y, 1.0, 1e-13));
        CHECK(near(found.z / exact.z, 1.0, 1e-13));
    }
}
