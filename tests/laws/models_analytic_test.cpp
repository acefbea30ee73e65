// Fitted skies: their formulas, their files, and what they refuse.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <random>

#include "atmosphere/presets.h"
#include "core/files.h"
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
