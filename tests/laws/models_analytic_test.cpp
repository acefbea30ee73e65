// Fitted skies: their formulas, their files, and what they refuse.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <random>

#include "atmosphere/presets.h"
#include "core/files.h"
#include "core/quadrature.h"
#include "models/hipiny2006_data.h"
#include "models/hosek2012_data.h"
#include "models/model.h"
#include "models/preetham1999_rgb.h"
#include "physics/models/f64.h"
#include "spectrum/colour.h"
#include "tools/temporary_folder.h"

using namespace airlight;

namespace {

// Points that differ in each number, near those of real skies.
Hosek2012Data some_sky() {
    Hosek2012Data data{{400.0, 500.0, 700.0}, {0.0, 1.0}, {1.0, 4.0, 10.0}, {}};
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0.9, 1.1);
    const double typical[] = {-1.0, -0.4, 0.5, 2.0, -3.0, 0.3, 0.01, 0.5, 0.7, 0.1};
    for (int i = 0; i < 18; ++i) {
        Hosek2012Points points;
        for (std::size_t c = 0; c < 10; ++c)
            for (double& p : points[c]) p = typical[c] * unit(random);
        data.points.push_back(points);
    }
    return data;
}

// A copy of the text with a line replaced, counted from 1.
std::string with_line(std::string text, int line, const std::string& by) {
    std::size_t at = 0;
    for (int i = 1; i < line; ++i) at = text.find('\n', at) + 1;
    return text.replace(at, text.find('\n', at) - at, by);
}

std::string complaint(const std::string& text) {
    const Result<Hosek2012Data> data = parse_hosek2012(text, "sky.csv");
    return data ? std::string("accepted") : data.error().message();
}

std::unique_ptr<Sky> hosek(std::vector<Wavelength> wavelengths, const ModelOptions& options) {
    auto sky = make_sky("hosek2012", *preset("earth-clear"), std::move(wavelengths), options);
    REQUIRE(sky);
    return std::move(*sky);
}

// The file of some_sky().
struct SomeFile {
    test::TemporaryFolder folder;
    std::filesystem::path path = folder.path / "sky.csv";
    SomeFile() { REQUIRE(write_file(path, hosek2012_csv(some_sky(), "# of no sky"))); }
};

const std::vector<Direction>& directions() {
    static const std::vector<Direction> all = [] {
        std::vector<Direction> some;
        std::mt19937 random(11);
        std::uniform_real_distribution<double> unit(0.0, 1.0);
        for (int i = 0; i < 1003; ++i) some.push_back({0.5 * pi * unit(random), 20.0 * (unit(random) - 0.5)});
        some.push_back({0.0, 0.0});
        some.push_back({0.5 * pi, pi});
        some.push_back({45.0 * deg, 0.0});
        return some;
    }();
    return all;
}

}  // namespace

TEST_CASE("hosek2012: a curve passes its first and last control points, and is a line where they lie on one") {
    const auto curve = [](double s) { return f64::quintic_bezier(1.0, 1.2, 1.4, 1.6, 1.8, 2.0, s).value; };
    CHECK(curve(0.0) == 1.0);
    CHECK(curve(1.0) == 2.0);
    for (const double s : {0.1, 0.35, 0.8}) CHECK(curve(s) == doctest::Approx(1.0 + s).epsilon(1e-14));
    CHECK(f64::hosek2012_place(0.5 * pi).value < 1e-5);
    CHECK(f64::hosek2012_place(0.0).value == 1.0);
    CHECK(f64::hosek2012_place(78.75 * deg).value == doctest::Approx(0.5));
}

TEST_CASE("hosek2012: without its gradation and its aureole the sky is even") {
    const f64::Hosek2012 even{0.0, -1.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.5, 0.25};
    for (const double mu : {0.0, 0.3, 1.0})
        for (const double nu : {-1.0, 0.2, 1.0}) CHECK(f64::hosek2012_radiance(even, mu, nu, std::acos(nu)).value == 0.25);
}

TEST_CASE("hosek2012: a file's text reads back to the same numbers") {
    const Hosek2012Data data = some_sky();
    const Result<Hosek2012Data> read = parse_hosek2012(hosek2012_csv(data, "# two\n# lines"), "sky.csv");
    REQUIRE(read);
    CHECK(read->wavelengths_nm == data.wavelengths_nm);
    CHECK(read->albedos == data.albedos);
    CHECK(read->turbidities == data.turbidities);
    CHECK(read->points == data.points);
}

TEST_CASE("hosek2012: at a turbidity and an albedo of the file its own points hold, between them the means") {
    const Hosek2012Data data = some_sky();
    CHECK(data.between(1, 0.0, 4.0) == data.points[data.index(1, 0, 1)]);
    CHECK(data.between(2, 1.0, 10.0) == data.points[data.index(2, 1, 2)]);
    const double mean = 0.25 * (data.points[data.index(0, 0, 0)][3][2] + data.points[data.index(0, 0, 1)][3][2] +
                                data.points[data.index(0, 1, 0)][3][2] + data.points[data.index(0, 1, 1)][3][2]);
    CHECK(data.between(0, 0.5, 2.5)[3][2] == doctest::Approx(mean));
}

TEST_CASE("hosek2012: a damaged file is refused with its line and what is wrong") {
    const std::string text = hosek2012_csv(some_sky(), "# of no sky");
    CHECK(complaint(with_line(text, 2, "wavelength,albedo")).starts_with("sky.csv:2: the columns are \"wavelength,albedo\""));
    CHECK(complaint(with_line(text, 7, "400,0,1,E,1,2,3,4,5")) == "sky.csv:7: has 9 cells: it must have 10");
    CHECK(complaint(with_line(text, 7, "400,0,1,E,1,2,3,4,5,nan")) == "sky.csv:7: p5 = \"nan\" is not a finite number");
    CHECK(complaint(with_line(text, 7, "400,0,1,J,1,2,3,4,5,6")).starts_with("sky.csv:7: \"J\" is no coefficient"));
    CHECK(complaint(with_line(text, 7, "400,2,1,E,1,2,3,4,5,6")) == "sky.csv:7: ground_albedo = 2 is out of range: it must be 0 to 1");
    CHECK(complaint(with_line(text, 7, "400,0,1,D,1,2,3,4,5,6")) == "sky.csv:7: 400 nm, albedo 0, turbidity 1, D is there twice");
    CHECK(complaint(with_line(text, 7, "")).starts_with("sky.csv:182: has no row of 400 nm, albedo 0, turbidity 1, E"));
    CHECK(complaint(with_line(text, 7, "401,0,1,E,1,2,3,4,5,6")).starts_with("sky.csv:182: has no row of"));
    CHECK(complaint("") == "sky.csv: has no line that names its columns");
    CHECK(complaint(text.substr(0, text.find("\n400") + 1)).starts_with("sky.csv:2: has no coefficients"));
}

TEST_CASE("hosek2012: what its data does not cover is refused with the range") {
    const SomeFile file;
    const auto refusal = [&](std::vector<Wavelength> wavelengths, ModelOptions options, double albedo = 0.2) {
        options.data = file.path;
        Atmosphere air = *preset("earth-clear");
        air.ground_albedo = SpectrumOf<Number>::constant(albedo);
        const auto sky = make_sky("hosek2012", air, std::move(wavelengths), options);
        return sky ? std::string("accepted") : sky.error().message();
    };
    CHECK(refusal({500.0 * nm}, {}) == "accepted");
    CHECK(refusal({399.0 * nm}, {}).find("does not answer 399 nm: its data is for 400 to 700 nm") != std::string::npos);
    CHECK(refusal({500.0 * nm}, {.turbidity = 11.0}).find("does not answer a turbidity of 11: its range is 1 to 10") != std::string::npos);
    const auto absent = make_sky("hosek2012", *preset("earth-clear"), {500.0 * nm}, {.data = file.folder.path / "none.csv"});
    REQUIRE(!absent);
    CHECK(absent.error().message().starts_with("--data: "));
    const auto sky = hosek({500.0 * nm}, {.data = file.path});
    CHECK(sky->radiance({0.0 * m, 0.2, 91.0 * deg, 0.0}).error().message().find("its range is 0 to 90 deg") != std::string::npos);
    CHECK(sky->radiance({100.0 * m, 0.2, 0.2, 0.0}).error().message().find("its range is 0 to 0 m") != std::string::npos);
    CHECK(!sky->dome(0.0 * m, 91.0 * deg));
}

TEST_CASE("hosek2012: between the wavelengths of its data radiance is linear") {
    const SomeFile file;
    const auto sky = hosek({400.0 * nm, 425.0 * nm, 500.0 * nm}, {.turbidity = 3.0, .data = file.path});
    const auto seen = sky->radiance({0.0 * m, 1.0, 0.7, 2.0})->radiance_W_m2_sr_nm;
    CHECK(seen[0] != seen[2]);
    CHECK(seen[1] == doctest::Approx(0.75 * seen[0] + 0.25 * seen[2]));
}

TEST_CASE("hosek2012: a dome's batch of directions has the radiance of single questions") {
    const SomeFile file;
    const auto sky = hosek({400.0 * nm, 450.0 * nm, 500.0 * nm, 640.0 * nm}, {.turbidity = 3.0, .data = file.path});
    const auto dome = *sky->dome(0.0 * m, 45.0 * deg);
    std::vector<float> seen(4 * directions().size());
    dome->radiances(directions(), seen);
    for (std::size_t i = 0; i < directions().size(); ++i) {
        const auto exact =
            sky->radiance({0.0 * m, directions()[i].view_zenith, 45.0 * deg, directions()[i].relative_azimuth})->radiance_W_m2_sr_nm;
        // Near the sun float's cosine loses the angle to 3.5e-4 rad, which its aureole of slope 3 shows as 1e-3.
        for (std::size_t w = 0; w < 4; ++w) CHECK(seen[4 * i + w] == doctest::Approx(exact[w]).epsilon(2e-3));
    }
    std::vector<float> below(4, 1.0f);
    dome->radiance(91.0 * deg, 0.0, below);
    CHECK(below == std::vector<float>(4, 0.0f));
}

TEST_CASE("preetham1999: colours of a batch are those of single questions") {
    const Preetham1999Rgb sky(2.53, 45.0 * deg);
    const RgbConverter converter(RgbSpace::srgb, WhitePoint::d65);
    std::vector<float> rgb(3 * directions().size());
    sky.radiances(directions(), rgb);
    for (std::size_t i = 0; i < directions().size(); ++i) {
        const Direction& d = directions()[i];
        const double nu = view_sun_cosine({0.0 * m, d.view_zenith, 45.0 * deg, d.relative_azimuth});
        const f64::ColourYxy c = f64::preetham1999_sky(f64::preetham1999(2.53, 45.0 * deg), std::cos(d.view_zenith), nu);
        const Rgb exact = converter.to_rgb(with_luminance({c.x.value, c.y.value}, c.luminance.value));
        CHECK(rgb[3 * i] == doctest::Approx(exact.r).epsilon(2e-3));
        CHECK(rgb[3 * i + 1] == doctest::Approx(exact.g).epsilon(2e-3));
        CHECK(rgb[3 * i + 2] == doctest::Approx(exact.b).epsilon(2e-3));
    }
}

TEST_CASE("cie2003 and perez1993: the sky's light on level ground is the atmosphere's, and a dome is as single questions") {
    const std::vector<Wavelength> wavelengths = {450.0 * nm, 550.0 * nm, 650.0 * nm};
    for (const char* key : {"cie2003", "perez1993"}) {
        CAPTURE(key);
        const auto sky = *make_sky(key, *preset("earth-clear"), wavelengths);
        const auto light = *sky->irradiance(0.0 * m, 40.0 * deg);
        const GaussRule zeniths = gauss_rule(48, 0.0, 0.5 * pi), azimuths = gauss_rule(48, 0.0, pi);
        std::vector<double> sum(3, 0.0);
        const auto dome = *sky->dome(0.0 * m, 40.0 * deg);
        std::vector<float> seen(3);
        for (std::size_t i = 0; i < 48; ++i)
            for (std::size_t j = 0; j < 48; ++j) {
                const double z = zeniths.nodes[i];
                dome->radiance(z, azimuths.nodes[j], seen);
                for (std::size_t w = 0; w < 3; ++w)
                    sum[w] += 2.0 * seen[w] * std::cos(z) * std::sin(z) * zeniths.weights[i] * azimuths.weights[j];
            }
        // The aureole has a kink at the sun, which neither rule has a node at.
        for (std::size_t w = 0; w < 3; ++w) CHECK(sum[w] == doctest::Approx(light.diffuse_W_m2_nm[w]).epsilon(5e-3));
        for (const Direction& d : {Direction{0.2, 1.0}, Direction{1.5, 3.0}, Direction{0.9, 0.1}}) {
            dome->radiance(d.view_zenith, d.relative_azimuth, seen);
            const auto exact = sky->radiance({0.0 * m, d.view_zenith, 40.0 * deg, d.relative_azimuth})->radiance_W_m2_sr_nm;
            for (std::size_t w = 0; w < 3; ++w) CHECK(seen[w] == doctest::Approx(exact[w]).epsilon(1e-4));
        }
        CHECK(!sky->radiance({0.0 * m, 0.2, 95.0 * deg, 0.0}));
        CHECK(!sky->dome(10.0 * m, 0.5));
    }
}

TEST_CASE("cie2003: type 5 is even, type 1 is three times as bright in the zenith as on the horizon, as Moon and Spencer's") {
    const auto sky = [](int type) { return *make_sky("cie2003", *preset("earth-clear"), {550.0 * nm}, {.cie_type = type}); };
    const auto seen = [](const Sky& of, double zenith, double azimuth) {
        return of.radiance({0.0 * m, zenith, 40.0 * deg, azimuth})->radiance_W_m2_sr_nm[0];
    };
    const auto even = sky(5), overcast = sky(1);
    CHECK(seen(*even, 0.0, 0.0) == doctest::Approx(seen(*even, 89.0 * deg, 2.0)));
    // 1 + 4 exp(-0.7 / cos Z): 2.99 at the zenith over 1.00.
    CHECK(seen(*overcast, 0.0, 0.0) / seen(*overcast, 89.9 * deg, 1.0) == doctest::Approx(1.0 + 4.0 * std::exp(-0.7)));
    const auto refused = make_sky("cie2003", *preset("earth-clear"), {550.0 * nm}, {.cie_type = 16});
    REQUIRE(!refused);
    CHECK(refused.error().message().starts_with("cie2003: has no sky of type 16: they are 1 to 15"));
}

TEST_CASE("cie2003: at right angles to the sun the indicatrix is one") {
    const f64::PerezCoefficients k{0.0, -1.0, 10.0, -3.0, 0.45};
    CHECK(f64::cie2003(k, 0.5, 0.0, 0.5 * pi).value == doctest::Approx(1.0));
}

TEST_CASE("perez1993: clearness is one without a beam, and the air mass is one in the zenith and 36.5 at the horizon") {
    CHECK(f64::sky_clearness(0.0, 0.3, 1.0).value == 1.0);
    CHECK(f64::sky_clearness(4.0, 1.0, 0.0).value == 5.0);
    CHECK(f64::relative_air_mass(0.0).value == doctest::Approx(1.0).epsilon(2e-3));
    CHECK(f64::relative_air_mass(0.5 * pi).value == doctest::Approx(36.5).epsilon(2e-3));
}

TEST_CASE("perez1993: an overcast sky darkens towards the horizon, a clear one brightens, most around the sun") {
    const auto sky = [](double clearness, double brightness) {
        return *make_sky("perez1993", *preset("earth-clear"), {550.0 * nm}, {.clearness = clearness, .brightness = brightness});
    };
    const auto seen = [](const Sky& s, double zenith, double azimuth) {
        return s.radiance({0.0 * m, zenith, 40.0 * deg, azimuth})->radiance_W_m2_sr_nm[0];
    };
    const auto overcast = sky(1.0, 0.2), clear = sky(8.0, 0.1);
    CHECK(seen(*overcast, 0.0, 0.0) > 1.3 * seen(*overcast, 85.0 * deg, 2.0));
    CHECK(seen(*clear, 85.0 * deg, 2.0) > 1.3 * seen(*clear, 30.0 * deg, 2.5));
    CHECK(seen(*clear, 41.0 * deg, 0.0) > 4.0 * seen(*clear, 30.0 * deg, 2.5));
    CHECK(!make_sky("perez1993", *preset("earth-clear"), {550.0 * nm}, {.clearness = 0.5}));
    CHECK(!make_sky("perez1993", *preset("earth-clear"), {550.0 * nm}, {.brightness = -0.5}));
}

TEST_CASE("preetham1999: sunlight fades by Beer's law in the air mass, and most in the blue") {
    const auto through = [](double mass, double um, double ozone) { return f64::preetham1999_sunlight(mass, um, 2.53, ozone).value; };
    CHECK(through(3.0, 0.5, 0.01) == doctest::Approx(std::pow(through(1.0, 0.5, 0.01), 3.0)));
    CHECK(through(1.0, 0.4, 0.0) < through(1.0, 0.5, 0.0));
    // 0.008735 0.55^-4.08 = 0.1001 and (0.04608 2.53 - 0.04586) 0.55^-1.3 = 0.1539.
    CHECK(-std::log(through(1.0, 0.55, 0.0)) == doctest::Approx(0.1001 + 0.1539).epsilon(1e-3));
}

TEST_CASE("preetham1999: in-scattering is that of single scattering along the way, level or not") {
    // By the midpoints of 20 000 steps. The cubic of the paper is off by up to 2 % over ways that rise through the whole haze.
    for (const double rise : {0.0, 5e-4, 0.01, 0.3, 2.0})
        for (const double own : {0.01, 0.5, 3.0})
            for (const double other : {0.0, 0.2, 2.0}) {
                const double other_rise = 0.2 * rise;
                double sum = 0.0;
                constexpr int steps = 20'000;
                for (int i = 0; i < steps; ++i) {
                    const double y = (i + 0.5) / steps;
                    const double depth = y * (own * f64::layer_share(y * rise).value + other * f64::layer_share(y * other_rise).value);
                    sum += std::exp(-y * rise - depth) / steps;
                }
                CAPTURE(rise);
                CAPTURE(own);
                CAPTURE(other);
                CHECK(f64::inscattered_share(own, rise, other, other_rise).value == doctest::Approx(sum).epsilon(0.02));
            }
}

TEST_CASE("preetham1999: nothing lies before a point at the eye, and far away the horizon's own light has come in its place") {
    const auto sky = *make_sky("preetham1999", *preset("earth-clear"), {450.0 * nm, 550.0 * nm, 650.0 * nm}, {.turbidity = 3.0});
    const View view{0.0 * m, 89.0 * deg, 40.0 * deg, 1.0};
    const auto near = *sky->aerial_perspective(view, 1e-3 * m), mid = *sky->aerial_perspective(view, 10.0 * km),
               far = *sky->aerial_perspective(view, 100.0 * km);
    const auto horizon = sky->radiance(view)->radiance_W_m2_sr_nm;
    for (std::size_t w = 0; w < 3; ++w) {
        CHECK(near.transmittance[w] == doctest::Approx(1.0));
        CHECK(near.inscattered_W_m2_sr_nm[w] < 1e-6);
        CHECK(mid.transmittance[w] > far.transmittance[w]);
        CHECK(mid.inscattered_W_m2_sr_nm[w] < far.inscattered_W_m2_sr_nm[w]);
        // One model of single scattering, one fitted to several orders: they agree to a factor of two.
        CHECK(far.inscattered_W_m2_sr_nm[w] > 0.5 * horizon[w]);
        CHECK(far.inscattered_W_m2_sr_nm[w] < 2.0 * horizon[w]);
    }
    CHECK(mid.transmittance[0] < mid.transmittance[2]);
    CHECK(!sky->transmittance(0.0 * m, 100.0 * deg, 1.0 * km));
}

namespace {

// Luminance that falls with altitude, of the colour of daylight.
Hipiny2006Data some_altitudes() {
    Hipiny2006Data data{{0.0, 4000.0, 10'000.0, 20'000.0, 30'000.0}, {2.0, 6.0}, {0.0, 60.0, 90.0}, {}};
    for (const double h : data.altitudes_m)
        for (const double t : data.turbidities)
            for (const double s : data.sun_zeniths_deg)
                data.patches.push_back({{-1.0, -0.3, 3.0 + t, -2.5, 0.3, 5000.0 * std::exp(-h / 8000.0) * (1.0 + s / 90.0)},
                                        {-0.2, -0.2, 0.2, -1.0, 0.04, 0.30},
                                        {-0.2, -0.2, 0.2, -1.0, 0.04, 0.31}});
    return data;
}

std::unique_ptr<Sky> hipiny(double turbidity) {
    const test::TemporaryFolder folder;
    REQUIRE(write_file(folder.path / "fit.csv", hipiny2006_csv(some_altitudes(), "# of no sky")));
    auto sky = make_sky("hipiny2006", *preset("earth-clear"), {450.0 * nm, 550.0 * nm, 650.0 * nm},
                        {.turbidity = turbidity, .data = folder.path / "fit.csv"});
    REQUIRE(sky);
    return std::move(*sky);
}

}  // namespace

TEST_CASE("hipiny2006: a file's text reads back to the same numbers, and a damaged one is refused with its line") {
    const std::string text = hipiny2006_csv(some_altitudes(), "# of no sky");
    const Result<Hipiny2006Data> read = parse_hipiny2006(text, "fit.csv");
    REQUIRE(read);
    CHECK(read->patches == some_altitudes().patches);
    const auto complaint_of = [](const std::string& damaged) { return parse_hipiny2006(damaged, "fit.csv").error().message(); };
    CHECK(complaint_of(with_line(text, 4, "0,2,0,z,0,0,0,0,0,1")).starts_with("fit.csv:4: \"z\" is no quantity"));
    CHECK(complaint_of(with_line(text, 4, "0,2,0,x,0,0.5,0,0,0,1")).starts_with("fit.csv:4: b = 0.5 is out of range"));
    CHECK(complaint_of(with_line(text, 4, "0,2,95,x,0,0,0,0,0,1")).starts_with("fit.csv:4: sun_zenith_deg = 95 is out of range"));
    CHECK(complaint_of(with_line(text, 4, "0,2,0,Y,0,0,0,0,0,1")).starts_with("fit.csv:4: 0 m, turbidity 2, sun 0 deg, Y is there twice"));
    CHECK(complaint_of(with_line(text, 4, "")).find("has 89 rows for 5 altitudes, 2 turbidities and 3 suns: 90 are needed") !=
          std::string::npos);
}

TEST_CASE("hipiny2006: at its altitudes the fit holds, and between them luminance falls as the air's density does") {
    const auto sky = hipiny(2.0);
    const auto up = [&](double altitude) { return sky->radiance({altitude * m, 0.0, 0.0, 0.0})->radiance_W_m2_sr_nm[1]; };
    CHECK(up(10'000.0) / up(0.0) == doctest::Approx(std::exp(-1.25)));
    CHECK(up(7000.0) / up(0.0) == doctest::Approx(std::exp(-7.0 / 8.0)));
    CHECK(up(30'000.0) > 0.0);
    CHECK(sky->radiance({31'000.0 * m, 0.0, 0.0, 0.0}).error().message().find("its range is 0 to 30000 m") != std::string::npos);
    CHECK(f64::hipiny2006_weight(f64::Length::of(0.0), f64::Length::of(0.0), f64::Length::of(1.0), f64::Length::of(8.0)).value == 0.0);
    CHECK(f64::hipiny2006_weight(f64::Length::of(9.0), f64::Length::of(0.0), f64::Length::of(9.0), f64::Length::of(8.0)).value == 1.0);
}

TEST_CASE("hipiny2006: what air takes of a point's light, it gives of the sky patch behind it") {
    const auto sky = hipiny(4.0);
    const View view{1000.0 * m, 80.0 * deg, 60.0 * deg, 1.0};
    const auto patch = sky->radiance(view)->radiance_W_m2_sr_nm;
    const auto air = *sky->aerial_perspective(view, 20.0 * km);
    for (std::size_t w = 0; w < 3; ++w) CHECK(air.inscattered_W_m2_sr_nm[w] == doctest::Approx((1.0 - air.transmittance[w]) * patch[w]));
    CHECK(air.transmittance[0] < air.transmittance[2]);
    // Beer and Lambert, over two legs.
    const double z = 80.0 * deg;
    const auto whole = *sky->transmittance(1000.0 * m, z, 20.0 * km), first = *sky->transmittance(1000.0 * m, z, 8.0 * km),
               second = *sky->transmittance((1000.0 + 8000.0 * std::cos(z)) * m, z, 12.0 * km);
    for (std::size_t w = 0; w < 3; ++w) CHECK(whole[w] == doctest::Approx(first[w] * second[w]));
}

TEST_CASE("hipiny2006: the shipped fit is the sky of tables, from the ground to 30 km") {
    const std::vector<Wavelength> wavelengths = {450.0 * nm, 550.0 * nm, 650.0 * nm};
    const Atmosphere air = *preset("earth-clear");
    const auto fit = *make_sky("hipiny2006", air, wavelengths);
    ModelOptions options;
    options.bake.sizes = {.transmittance_mu = 64, .transmittance_altitude = 32, .sun = 16, .azimuth = 4, .view = 8, .altitude = 8};
    options.bake.orders = 3;
    const test::TemporaryFolder cache;
    options.cache.folder = cache.path;
    const auto tables = *make_sky("tables", air, wavelengths, options);
    for (const double altitude : {0.0, 10'000.0, 30'000.0})
        for (const Direction& d : {Direction{0.2, 2.0}, Direction{0.9, 1.6}, Direction{1.3, 3.0}}) {
            const View view{altitude * m, d.view_zenith, 50.0 * deg, d.relative_azimuth};
            const double a = fit->radiance(view)->radiance_W_m2_sr_nm[1], b = tables->radiance(view)->radiance_W_m2_sr_nm[1];
            CAPTURE(altitude);
            CAPTURE(d.view_zenith);
            // Its residual is 4 %; a wavelength's share of a daylight of the right colour is a little off beside.
            CHECK(a == doctest::Approx(b).epsilon(0.2));
        }
}

namespace {

// The authors' layout with radiance 1 + visibility's place + 4 channel's place, halved by the emphasis, and a transmittance of 0.64.
std::string prague_bytes() {
    std::string bytes;
    const auto add = [&](auto value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
    const auto axis = [&](std::initializer_list<double> values) {
        add(static_cast<int>(values.size()));
        for (const double v : values) add(v);
    };
    const auto half = [&](int small) {  // 0.5 to 8, whole numbers and 0.5
        const std::uint16_t bits[] = {0x3800, 0x3C00, 0x4000, 0x4200, 0x4400, 0x4500, 0x4600, 0x4700};
        add(bits[small]);
    };
    axis({20.0, 60.0});
    axis({0.0, 1.0});
    axis({0.0, 15'000.0});
    axis({-4.0, 90.0});
    add(2);  // channels
    add(400.0);
    add(40.0);
    add(1);  // rank
    for (int i = 0; i < 3; ++i) axis({0.0, pi});
    for (int configuration = 0; configuration < 32; ++configuration) {
        const int value = 1 + configuration / 16 + 4 * (configuration % 2);
        for (int i = 0; i < 2; ++i) half(value);
        add(2.0);
        for (int i = 0; i < 2; ++i) half(2);
        for (int i = 0; i < 2; ++i) half(0);
    }
    for (const int n : {3, 2, 1, 1, 1}) add(n);  // distances, grid altitudes, visibilities, altitudes, rank
    add(0.0f);
    add(50.0f);
    for (int i = 0; i < 6; ++i) add(1.0f);
    for (int i = 0; i < 2; ++i) add(0.8f);
    return bytes;
}

Result<std::unique_ptr<Sky>> prague(const std::string& bytes, double visibility_km, std::vector<Wavelength> wavelengths) {
    const test::TemporaryFolder folder;
    REQUIRE(write_file(folder.path / "sky.dat", bytes));
    Atmosphere air = *preset("earth-rayleigh");
    air.constituents.resize(1);
    air.constituents[0].scattering = SpectrumOf<InverseLength>::constant(std::log(50.0) / visibility_km / 1000.0 * per_m);
    return make_sky("prague2021", air, std::move(wavelengths), {.data = folder.path / "sky.dat"});
}

}  // namespace

TEST_CASE("prague2021: a data set in the authors' layout answers with its numbers, between visibilities evenly") {
    const auto sky = prague(prague_bytes(), 30.0, {410.0 * nm, 450.0 * nm});
    if (!sky) FAIL(sky.error().message());
    for (const View& view : {View{0.0 * m, 1.0, 0.5, 0.3}, View{5000.0 * m, 0.2, 92.0 * deg, 2.0}}) {
        const auto seen = (*sky)->radiance(view)->radiance_W_m2_sr_nm;
        CHECK(seen[0] == doctest::Approx(0.5 * 1.25));
        CHECK(seen[1] == doctest::Approx(0.5 * 5.25));
    }
    const std::vector<double> through = *(*sky)->transmittance(0.0 * m, 1.0, 10.0 * km);
    for (const double t : through) CHECK(t == doctest::Approx(0.64));
    CHECK((*prague(prague_bytes(), 20.0, {410.0 * nm}))->radiance({0.0 * m, 1.0, 0.5, 0.3})->radiance_W_m2_sr_nm[0] ==
          doctest::Approx(0.5));
    CHECK(!(*sky)->radiance({0.0 * m, 1.0, 94.5 * deg, 0.0}));
    CHECK(!(*sky)->radiance({16.0 * km, 1.0, 0.5, 0.0}));
}

TEST_CASE("prague2021: absent or damaged data and what it does not cover are refused, each with one message") {
    const auto complaint_of = [](const std::string& bytes, double visibility, Wavelength w) {
        const auto sky = prague(bytes, visibility, {w});
        return sky ? std::string("accepted") : sky.error().message();
    };
    const std::string bytes = prague_bytes();
    CHECK(make_sky("prague2021", *preset("earth-clear"), {550.0 * nm}).error().message().starts_with("prague2021: has no data of its own"));
    CHECK(complaint_of(bytes, 30.0, 410.0 * nm) == "accepted");
    CHECK(complaint_of(bytes, 30.0, 480.0 * nm).find("does not answer 480 nm: its data is for 400 to 480 nm") != std::string::npos);
    CHECK(complaint_of(bytes, 70.0, 410.0 * nm).find("does not answer a visibility of 70 km: its data is for 20 to 60 km") !=
          std::string::npos);
    CHECK(complaint_of(bytes.substr(0, 200), 30.0, 410.0 * nm).find("sky.dat: ends within its radiance") != std::string::npos);
    CHECK(complaint_of(bytes.substr(0, bytes.size() - 4), 30.0, 410.0 * nm).find("ends within its transmittance") != std::string::npos);
    CHECK(complaint_of("", 30.0, 410.0 * nm).find("ends within visibilities") != std::string::npos);
    CHECK(complaint_of(std::string(64, '\x7f'), 30.0, 410.0 * nm).find("it must have 1 to 4096") != std::string::npos);
}
