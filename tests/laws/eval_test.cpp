// The judge: colour differences against published pairs, scores of skies whose error is known, files that are damaged.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <fstream>

#include "atmosphere/presets.h"
#include "core/files.h"
#include "eval/aerial.h"
#include "eval/ciede2000.h"
#include "eval/drawn.h"
#include "eval/measured_sky.h"
#include "eval/models_page.h"
#include "eval/picture_difference.h"
#include "eval/report.h"
#include "eval/truth_file.h"
#include "tools/temporary_folder.h"

using namespace airlight;

namespace {

// Two colours of CIELAB and their difference: [SharmaWuDalal2005, table 1], all 34.
struct Pair {
    Lab one, other;
    double difference;
};
constexpr Pair published[] = {{{50.0, 2.6772, -79.7751}, {50.0, 0.0, -82.7485}, 2.0425},
                              {{50.0, 3.1571, -77.2803}, {50.0, 0.0, -82.7485}, 2.8615},
                              {{50.0, 2.8361, -74.0200}, {50.0, 0.0, -82.7485}, 3.4412},
                              {{50.0, -1.3802, -84.2814}, {50.0, 0.0, -82.7485}, 1.0000},
                              {{50.0, -1.1848, -84.8006}, {50.0, 0.0, -82.7485}, 1.0000},
                              {{50.0, -0.9009, -85.5211}, {50.0, 0.0, -82.7485}, 1.0000},
                              {{50.0, 0.0, 0.0}, {50.0, -1.0, 2.0}, 2.3669},
                              {{50.0, -1.0, 2.0}, {50.0, 0.0, 0.0}, 2.3669},
                              {{50.0, 2.4900, -0.0010}, {50.0, -2.4900, 0.0009}, 7.1792},
                              {{50.0, 2.4900, -0.0010}, {50.0, -2.4900, 0.0010}, 7.1792},
                              {{50.0, 2.4900, -0.0010}, {50.0, -2.4900, 0.0011}, 7.2195},
                              {{50.0, 2.4900, -0.0010}, {50.0, -2.4900, 0.0012}, 7.2195},
                              {{50.0, -0.0010, 2.4900}, {50.0, 0.0009, -2.4900}, 4.8045},
                              {{50.0, -0.0010, 2.4900}, {50.0, 0.0010, -2.4900}, 4.8045},
                              {{50.0, -0.0010, 2.4900}, {50.0, 0.0011, -2.4900}, 4.7461},
                              {{50.0, 2.5000, 0.0}, {50.0, 0.0, -2.5000}, 4.3065},
                              {{50.0, 2.5000, 0.0}, {73.0, 25.0, -18.0}, 27.1492},
                              {{50.0, 2.5000, 0.0}, {61.0, -5.0, 29.0}, 22.8977},
                              {{50.0, 2.5000, 0.0}, {56.0, -27.0, -3.0}, 31.9030},
                              {{50.0, 2.5000, 0.0}, {58.0, 24.0, 15.0}, 19.4535},
                              {{50.0, 2.5000, 0.0}, {50.0, 3.1736, 0.5854}, 1.0000},
                              {{50.0, 2.5000, 0.0}, {50.0, 3.2972, 0.0}, 1.0000},
                              {{50.0, 2.5000, 0.0}, {50.0, 1.8634, 0.5757}, 1.0000},
                              {{50.0, 2.5000, 0.0}, {50.0, 3.2592, 0.3350}, 1.0000},
                              {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
                              {{63.0109, -31.0961, -5.8663}, {62.8187, -29.7946, -4.0864}, 1.2630},
                              {{61.2901, 3.7196, -5.3901}, {61.4292, 2.2480, -4.9620}, 1.8731},
                              {{35.0831, -44.1164, 3.7933}, {35.0232, -40.0716, 1.5901}, 1.8645},
                              {{22.7233, 20.0904, -46.6940}, {23.0331, 14.9730, -42.5619}, 2.0373},
                              {{36.4612, 47.8580, 18.3852}, {36.2715, 50.5065, 21.2231}, 1.4146},
                              {{90.8027, -2.0831, 1.4410}, {91.1528, -1.6435, 0.0447}, 1.4441},
                              {{90.9257, -0.5406, -0.9208}, {88.6381, -0.8985, -0.7239}, 1.5381},
                              {{6.7747, -0.2908, -2.4247}, {5.8714, -0.0985, -2.2286}, 0.6377},
                              {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082}};

// A uniform sky, `factor` times as bright as one of the solar irradiance per steradian; it answers up to a zenith angle.
class EvenSky : public Sky {
public:
    EvenSky(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, double factor, double highest_view = pi)
        : atmosphere_(atmosphere), wavelengths_(std::move(wavelengths)), factor_(factor), highest_view_(highest_view) {}
    std::string name() const override { return "even"; }
    std::span<const Wavelength> wavelengths() const override { return wavelengths_; }
    Result<RadianceEstimate> radiance(const View& view) const override {
        if (view.view_zenith > highest_view_) return Error{"even", "looks up only", ""};
        RadianceEstimate seen;
        for (const Wavelength w : wavelengths_)
            seen.radiance_W_m2_sr_nm.push_back(factor_ * atmosphere_.sun.irradiance.at(w).in(W_per_m2_nm));
        seen.standard_error.assign(wavelengths_.size(), 0.0);
        return seen;
    }
    Result<IrradianceEstimate> irradiance(Length, double) const override {
        IrradianceEstimate light;
        const Result<RadianceEstimate> seen = radiance({});
        if (!seen) return seen.error();
        for (const double r : seen->radiance_W_m2_sr_nm) light.diffuse_W_m2_nm.push_back(pi * r);
        light.direct_W_m2_nm = light.standard_error = std::vector<double>(wavelengths_.size(), 0.0);
        return light;
    }
    Result<std::vector<double>> transmittance(Length, double, Length) const override {
        return std::vector<double>(wavelengths_.size(), 1.0);
    }

private:
    Length bottom_radius() const override { return atmosphere_.bottom_radius; }
    Atmosphere atmosphere_;
    std::vector<Wavelength> wavelengths_;
    double factor_, highest_view_;
};

const Condition at_2_km{2.0 * km, 60.0};

struct Bench {
    Atmosphere atmosphere = *preset("earth-rayleigh");
    WavelengthGrid grid = *parse_wavelength_grid("450,550,650");
    std::vector<Wavelength> wavelengths{grid.begin(), grid.end()};
    ColourWeights weights{grid, atmosphere.sun.irradiance};
    EvenSky sky(double factor, double highest_view = pi) const { return {atmosphere, wavelengths, factor, highest_view}; }
    SkyTruth truth(const Condition& condition = at_2_km) const { return *truth_by(sky(1.0), atmosphere, condition, {}); }
    Verdict verdict(const Sky& model, const SkyTruth& truth) const { return judged(model, truth, atmosphere.sun, weights); }
};

std::string measured_file(const test::TemporaryFolder& folder, const std::string& text) {
    const std::filesystem::path path = folder.path / "measured.csv";
    REQUIRE(write_file(path, text));
    return path.string();
}

// A blue that gets paler downward, by a level a row; each of its channels more by `more`, shifted by rows, its levels dithered by +-amount.
PngLevels gradient(std::array<int, 3> more, int rows, double amount) {
    PngLevels picture{64, 36, 3, 8, {}};
    for (int row = 0; row < picture.height; ++row)
        for (int column = 0; column < picture.width; ++column)
            for (int channel = 0; channel < 3; ++channel) {
                const double dither = (row + column) % 2 == 0 ? amount : -amount;
                const std::array<int, 3> blue = {70 + row + rows, 110 + row + rows, 160 + row + rows};
                const auto at = static_cast<std::size_t>(channel);
                picture.levels.push_back(static_cast<std::uint16_t>(blue[at] + more[at] + dither));
            }
    return picture;
}

// Dark to the left of a column, light from it on.
PngLevels edge_at(int edge) {
    PngLevels picture{40, 10, 3, 8, {}};
    for (int i = 0; i < picture.width * picture.height; ++i)
        picture.levels.insert(picture.levels.end(), 3, i % picture.width < edge ? std::uint16_t{40} : std::uint16_t{200});
    return picture;
}

PictureDifference difference_of(const PngLevels& one, const PngLevels& other) {
    Result<PictureDifference> difference = picture_difference(one, other);
    if (!difference) FAIL(difference.error().message());
    return *std::move(difference);
}

}  // namespace

TEST_CASE("CIEDE2000 gives the published differences of the published pairs, both ways") {
    for (const Pair& pair : published) {
        CAPTURE(pair.difference);
        // Published to four decimals.
        CHECK(std::abs(ciede2000(pair.one, pair.other) - pair.difference) < 0.5e-4 + 1e-12);
        CHECK(ciede2000(pair.one, pair.other) == doctest::Approx(ciede2000(pair.other, pair.one)).epsilon(1e-12));
    }
}

TEST_CASE("white is the lightest grey of CIELAB, and grey of 18.4 % is half as light") {
    const Xyz white{0.95, 1.0, 1.09};
    CHECK(lab(white, white).l == doctest::Approx(100.0));
    CHECK(std::hypot(lab(white, white).a, lab(white, white).b) < 1e-12);
    // L* = 50: (66/116)^3.
    CHECK(lab(std::pow(66.0 / 116.0, 3.0) * white, white).l == doctest::Approx(50.0));
    CHECK(lab({0.0, 0.0, 0.0}, white).l == doctest::Approx(0.0));
}

TEST_CASE("pictures: equal ones do not differ, a level of 255 and dither are not seen, a shade of eight and another hue are") {
    const PngLevels sky = gradient({0, 0, 0}, 0, 0.0);
    CHECK(difference_of(sky, sky).mean == 0.0);
    CHECK(difference_of(sky, sky).high == 0.0);
    CHECK(difference_of(sky, gradient({1, 1, 1}, 0, 0.0)).high < 0.5);
    CHECK(difference_of(sky, gradient({0, 0, 0}, 0, 1.0)).high < 0.5);
    CHECK(difference_of(sky, gradient({8, 8, 8}, 0, 0.0)).mean > 1.0);
    CHECK(difference_of(sky, gradient({0, 8, 0}, 0, 0.0)).mean > 1.0);
    const PngLevels lighter = gradient({8, 8, 8}, 0, 0.0);
    CHECK(difference_of(sky, lighter).mean == doctest::Approx(difference_of(lighter, sky).mean).epsilon(1e-12));
}

TEST_CASE("pictures: a smooth one shifted by a pixel is the same, an edge shifted by one is seen where it is, and nowhere else") {
    CHECK(difference_of(gradient({0, 0, 0}, 0, 0.0), gradient({0, 0, 0}, 1, 0.0)).high < 1.0);
    const PictureDifference edge = difference_of(edge_at(20), edge_at(21));
    CHECK(edge.high > 10.0);
    CHECK(edge.pixels.pixel(10, 5)[0] == 0.0f);
    CHECK(edge.pixels.pixel(20, 5)[0] > 10.0f);
    CHECK(edge.pixels.pixel(30, 5)[0] == 0.0f);
}

TEST_CASE("pictures of other sizes, or of greys, are not compared") {
    PngLevels wide = edge_at(20), grey = edge_at(20);
    wide.width /= 2, wide.height *= 2;
    grey.channels = 1, grey.width *= 3;
    CHECK(!picture_difference(wide, edge_at(20)));
    CHECK(!picture_difference(grey, grey));
}

TEST_CASE("a sky that is the truth has no error, and one a tenth too bright has a tenth of error and no other colour") {
    const Bench bench;
    const Verdict same = bench.verdict(bench.sky(1.0), bench.truth()), brighter = bench.verdict(bench.sky(1.1), bench.truth());
    for (const std::optional<Score>& score : {same.sky, same.ground}) {
        REQUIRE(score);
        CHECK(score->plain_rmse == 0.0);
        CHECK(score->colour_difference == 0.0);
    }
    REQUIRE(brighter.sky);
    CHECK(brighter.sky->relative_rmse == doctest::Approx(0.1));
    CHECK(brighter.sky->bias == doctest::Approx(0.1));
    CHECK(brighter.sky->luminance_rmse == doctest::Approx(0.1));
    CHECK(brighter.sky->chromaticity_rmse < 1e-12);
    CHECK(brighter.sky->colour_difference > 1.0);
    REQUIRE(brighter.horizontal);
    CHECK(brighter.horizontal->diffuse_lx == doctest::Approx(1.1 * same.horizontal->diffuse_lx));
}

TEST_CASE("an error that is the truth's own noise is taken off, and no more than that") {
    const Bench bench;
    SkyTruth truth = bench.truth();
    for (RadianceEstimate& seen : truth.radiance)
        for (std::size_t w = 0; w < seen.standard_error.size(); ++w) seen.standard_error[w] = 0.03 * seen.radiance_W_m2_sr_nm[w];
    const Score near = *bench.verdict(bench.sky(1.02), truth).sky, far = *bench.verdict(bench.sky(1.05), truth).sky;
    CHECK(near.relative_rmse == 0.0);
    CHECK(near.plain_rmse == doctest::Approx(0.02));
    CHECK(far.noise == doctest::Approx(0.03));
    CHECK(far.relative_rmse == doctest::Approx(0.04));  // 3, 4, 5
}

TEST_CASE("where a model does not answer there is its reason and no number") {
    const Bench bench;
    const Verdict verdict = bench.verdict(bench.sky(1.0, 0.5 * pi), bench.truth());
    CHECK(verdict.refusal == "looks up only");
    CHECK(!verdict.ground);
    REQUIRE(verdict.sky);
    CHECK(verdict.sky->answered < verdict.sky->asked);  // at 2 km the horizon lies below 90 degrees
    CHECK(!bench.verdict(bench.sky(1.0, -1.0), bench.truth()).sky);
}

TEST_CASE("what is darker than 1e-8 of sunlight is not judged") {
    const Bench bench;
    const SkyTruth night = *truth_by(bench.sky(0.9e-8), bench.atmosphere, at_2_km, {}),
                   dusk = *truth_by(bench.sky(1.1e-8), bench.atmosphere, at_2_km, {});
    CHECK(!bench.verdict(bench.sky(1.0), night).sky);
    CHECK(bench.verdict(bench.sky(1.0), dusk).sky);
}

TEST_CASE("directions are on the side of the horizon that they say, and none is within a degree of the sun") {
    const Atmosphere atmosphere = *preset("earth-clear");
    for (const double altitude_m : {0.0, 2000.0, 30'000.0, 400'000.0})
        for (const double sun_deg : {0.0, 35.0, 89.0, 108.0}) {
            const Condition condition{altitude_m * m, sun_deg};
            const std::vector<JudgedDirection> directions = judged_directions(atmosphere, condition);
            CHECK(directions.size() >= 10);
            const double horizon = horizon_zenith(atmosphere.bottom_radius, condition.altitude);
            for (const JudgedDirection& d : directions) {
                CHECK(d.above_horizon == (d.direction.view_zenith < horizon));
                CHECK(std::acos(view_sun_cosine(view_of(condition, d.direction))) >= 1.0 * deg);
            }
        }
}

TEST_CASE("a finished truth reads back to the same bits, and a damaged or a foreign one is refused") {
    const Bench bench;
    const test::TemporaryFolder folder;
    const SkyTruth truth = bench.truth();
    const TruthOrigin origin = truth_origin(bench.atmosphere, bench.wavelengths, at_2_km, 1024, 1);
    const std::filesystem::path path = truth_path(folder.path, origin);
    REQUIRE(write_truth(path, origin, truth));
    const Result<SkyTruth> read = read_truth(path, origin, bench.atmosphere, at_2_km);
    REQUIRE(read);
    for (std::size_t i = 0; i < truth.radiance.size(); ++i)
        CHECK(read->radiance[i].radiance_W_m2_sr_nm == truth.radiance[i].radiance_W_m2_sr_nm);
    CHECK(read->irradiance->diffuse_W_m2_nm == truth.irradiance->diffuse_W_m2_nm);

    const TruthOrigin other = truth_origin(bench.atmosphere, bench.wavelengths, at_2_km, 2048, 1);
    CHECK(other.key != origin.key);
    CHECK(!read_truth(path, other, bench.atmosphere, at_2_km));
    const std::string whole = *read_file(path);
    for (const std::size_t place : {std::size_t{30}, whole.size() / 2, whole.size() - 2}) {
        std::string damaged = whole;
        damaged[place] = damaged[place] == '7' ? '8' : '7';
        REQUIRE(write_file(path, damaged));
        CHECK(!read_truth(path, origin, bench.atmosphere, at_2_km));
    }
    REQUIRE(write_file(path, whole.substr(0, whole.size() / 2)));
    CHECK(!read_truth(path, origin, bench.atmosphere, at_2_km));
}

TEST_CASE("a measured sky is read by its columns, and what is missing or wrong is named with its place") {
    const test::TemporaryFolder folder;
    const std::string head = "time,sun_zenith_deg,sun_azimuth_deg,i,view_zenith_deg,view_azimuth_deg,450,550,900\n";
    const auto read = [&](const std::string& text) { return read_measured_sky(measured_file(folder, text), 360.0 * nm, 720.0 * nm); };
    const Result<MeasuredSky> good =
        read("# a day\n" + head + "09h,40,90,0,10,100,0.1,0.2,0.3\n09h,40,90,1,20,80,0.1,0.2,0.3\n10h,30,90,0,10,0,1,2,3\n");
    REQUIRE(good);
    CHECK(good->wavelengths.size() == 2);
    REQUIRE(good->skies.size() == 2);
    CHECK(good->skies[0].directions.size() == 2);
    CHECK(good->skies[0].directions[1].direction.relative_azimuth == doctest::Approx(-10.0 * deg));
    CHECK(good->skies[1].radiance[0].radiance_W_m2_sr_nm == std::vector<double>{1.0, 2.0});

    const auto message = [&](const std::string& text) { return read(text).error().message(); };
    CHECK(message("time,sun_zenith_deg,view_zenith_deg,view_azimuth_deg,450\n")
              .find("measured.csv:1: the column sun_azimuth_deg is missing") != std::string::npos);
    CHECK(message("# a day\n" + head + "09h,40,90,0,10,100,0.1,x,0.3\n").find("measured.csv:3: column 550: \"x\" is no number") !=
          std::string::npos);
    CHECK(message(head + "09h,40,90\n").find("measured.csv:2: has 3 cells, the head has 9") != std::string::npos);
    CHECK(message("time,sun_zenith_deg,sun_azimuth_deg,view_zenith_deg,view_azimuth_deg,900\n").find("no column is a wavelength") !=
          std::string::npos);
    CHECK(!read(head));
    CHECK(!read(""));
}

TEST_CASE("a card tells which orders its model computes") {
    const auto orders = [](std::string_view scattering) {
        ModelCard card = find_model("tables")->card;
        card.scattering = scattering;
        return orders_of(card);
    };
    CHECK(orders("single") == Orders::single);
    CHECK(orders("single exact; higher orders from tables") == Orders::several);
    CHECK(orders("multiple") == Orders::several);
    CHECK(orders("fitted to all orders") == Orders::fitted);
    CHECK(orders("none") == Orders::none);
}

TEST_CASE("base64 is that of RFC 4648") {
    const std::pair<const char*, const char*> published_texts[] = {
        {"", ""}, {"f", "Zg=="}, {"fo", "Zm8="}, {"foo", "Zm9v"}, {"foob", "Zm9vYg=="}, {"fooba", "Zm9vYmE="}, {"foobar", "Zm9vYmFy"}};
    for (const auto& [bytes, text] : published_texts) CHECK(base64(bytes) == text);
}

TEST_CASE("maps are white where a model is right, and ever redder where it is brighter") {
    CHECK(hex(deviation_colour(0.0)) == "#ffffff");
    CHECK(deviation_colour(0.1).g > deviation_colour(0.4).g);
    CHECK(deviation_colour(0.3).r > deviation_colour(0.3).b);
    CHECK(deviation_colour(-0.3).b > deviation_colour(-0.3).r);
    CHECK(hex(deviation_colour(7.0)) == hex(deviation_colour(0.5)));
}

TEST_CASE("a comparison's page needs no other file, names every model, and says why one does not answer") {
    const Bench bench;
    CompareSettings settings{
        .airs = {{"thin & <clear>", bench.atmosphere}}, .models = {"tables", "preetham1999"}, .against = Against::tables};
    settings.conditions = {{0.0 * m, 40.0}, {0.0 * m, 96.0}};
    settings.wavelengths = bench.grid;
    settings.options.bake = {
        .sizes = {.transmittance_mu = 64, .transmittance_altitude = 32, .sun = 16, .azimuth = 4, .view = 8, .altitude = 8}, .orders = 3};
    settings.picture_size = 24;
    const Result<Comparison> comparison = compare(settings);
    REQUIRE(comparison);
    const std::string html = report_html(*comparison);
    for (const char* word :
         {"thin &amp; &lt;clear&gt;", "id=\"m0-tables\"", "id=\"m0-preetham1999\"", "prefers-color-scheme", "data:image/png;base64,"})
        CHECK(html.find(word) != std::string::npos);
    for (const char* outside : {"http:", "https:", "//cdn", "<link", "@import", "url("}) CHECK(html.find(outside) == std::string::npos);
    const AirRun& air = comparison->airs.front();
    REQUIRE(air.models.size() == 2);
    CHECK(air.models[0].cells[0].verdict.sky->plain_rmse == 0.0);  // the tables are their own truth
    CHECK(air.models[0].making.core_seconds > 0.0);
    CHECK(air.models[0].making.bytes > 1000);
    // An atmosphere of molecules alone has turbidity 1, which this model does not take.
    CHECK(air.models[1].refusal.find("turbidity") != std::string::npos);
    const std::string csv = report_csv(*comparison);
    CHECK(std::count(csv.begin(), csv.end(), '\n') == 1 + 4);
    CHECK(nearest_first(air) == std::vector<std::size_t>{0, 1});
    CHECK(models_page(*comparison, "make models").find("`tables`") != std::string::npos);
}

namespace {

// Air of one transmittance that adds one light, up to a distance.
class EvenAir : public Sky {
public:
    EvenAir(double light, double transmittance, Length furthest) : light_(light), transmittance_(transmittance), furthest_(furthest) {}
    std::string name() const override { return "even air"; }
    std::span<const Wavelength> wavelengths() const override { return {}; }
    Result<RadianceEstimate> radiance(const View&) const override { return Error{"", "none", ""}; }
    Result<IrradianceEstimate> irradiance(Length, double) const override { return Error{"", "none", ""}; }
    Result<std::vector<double>> transmittance(Length, double, Length) const override { return Error{"", "none", ""}; }
    Result<AerialPerspective> aerial_perspective(const View&, Length distance) const override {
        if (distance > furthest_) return Error{"even air", "ends before", ""};
        return AerialPerspective{{transmittance_, transmittance_}, {light_, light_}};
    }

private:
    Length bottom_radius() const override { return 6360.0 * km; }
    double light_, transmittance_;
    Length furthest_;
};

}  // namespace

TEST_CASE("aerial perspective is judged by the relative error of its light and the difference of its transmittance, distance by distance") {
    std::vector<AerialTruth> truths;
    for (const std::size_t d : {0, 0, 1, 2}) truths.push_back({{}, d, {0.5, 0.5}, {{2.0, 2.0}, {0.0, 0.0}}});
    const AerialVerdict verdict = judged_aerial(EvenAir(2.2, 0.6, 20.0 * km), truths);
    CHECK(verdict.at[0].asked == 2);
    CHECK(verdict.at[2].asked == 1);
    CHECK(verdict.at[2].answered == 0);
    CHECK(verdict.refusal == "ends before");
    for (const int d : {0, 1}) {
        CHECK(verdict.at[static_cast<std::size_t>(d)].light_rmse == doctest::Approx(0.1));
        CHECK(verdict.at[static_cast<std::size_t>(d)].transmittance_rmse == doctest::Approx(0.1));
    }
    // The truth's variance is taken off.
    for (AerialTruth& truth : truths) truth.inscattered.standard_error = {0.2, 0.2};
    CHECK(judged_aerial(EvenAir(2.2, 0.6, 20.0 * km), truths).at[0].light_rmse < 1e-7);
    CHECK(judged_aerial(EvenAir(2.2, 0.6, 20.0 * km), truths).at[0].noise == doctest::Approx(0.1));
}

TEST_CASE("points behind the ground are not looked at, and aerial perspective is judged by day from within the air") {
    const Bench bench;
    CHECK(aerial_judged(bench.atmosphere, {2.0 * km, 60.0}));
    CHECK(!aerial_judged(bench.atmosphere, {2.0 * km, 85.0}));
    CHECK(!aerial_judged(bench.atmosphere, {400.0 * km, 30.0}));
    const Reference reference = *Reference::of(bench.atmosphere, {bench.grid.begin(), bench.grid.end()});
    // From the ground nothing is seen 4 degrees below the horizontal; from 2 km the ground is 29 km away there.
    CHECK(aerial_truths(reference, bench.atmosphere, {0.0 * m, 60.0}, {.paths = 128})->size() == 6);
    CHECK(aerial_truths(reference, bench.atmosphere, {2.0 * km, 60.0}, {.paths = 128})->size() == 8);
}

TEST_CASE("a page of one eye has a column for each sun, and says no cost ahead of tables that were kept") {
    const Bench bench;
    const test::TemporaryFolder folder;
    CompareSettings settings{.airs = {{"thin", bench.atmosphere}}, .models = {"tables", "kaneda1991"}, .against = Against::tables};
    settings.conditions = {{0.0 * m, 40.0}, {0.0 * m, 80.0}};
    settings.wavelengths = bench.grid;
    settings.options.bake = {
        .sizes = {.transmittance_mu = 64, .transmittance_altitude = 32, .sun = 16, .azimuth = 4, .view = 8, .altitude = 8}, .orders = 3};
    settings.options.cache.folder = folder.path;
    settings.kept_tables = true;
    settings.picture_size = 0;
    const Result<Comparison> comparison = compare(settings);
    REQUIRE(comparison);
    const std::string page = models_page(*comparison, "make models");
    CHECK(page.find("| sun 40° | sun 80° |") != std::string::npos);
    CHECK(page.find("## Model by model") == std::string::npos);
    CHECK(!std::filesystem::is_empty(folder.path));
    const std::size_t row = page.find("| `kaneda1991` |");
    REQUIRE(row != std::string::npos);
    CHECK(page.substr(row, page.find('\n', row) - row).find("| – |") != std::string::npos);
}

TEST_CASE("aerial perspective stands on the page of models, in the report and in the JSON") {
    const Bench bench;
    const test::TemporaryFolder folder;
    CompareSettings settings{.airs = {{"thin", bench.atmosphere}}, .models = {"kaneda1991", "perez1993"}};
    settings.conditions = {{0.0 * m, 40.0}};
    settings.wavelengths = bench.grid;
    settings.paths = 128;
    settings.truth_folder = folder.path;
    settings.picture_size = 0;
    settings.aerial_perspective = true;
    const Result<Comparison> comparison = compare(settings);
    REQUIRE(comparison);
    const std::string page = models_page(*comparison, "make models"), html = report_html(*comparison), json = report_json(*comparison);
    CHECK(page.find("| aerial perspective | to 2 km | to 10 km | to 50 km |") != std::string::npos);
    CHECK(html.find("<h3>Aerial perspective</h3>") != std::string::npos);
    CHECK(json.find("\"aerial_perspective\":[{\"distance_m\":2000,\"asked\":2,\"answered\":2,") != std::string::npos);
    // perez1993 has none, and says so by its absence from the table.
    const std::size_t table = page.find("| aerial perspective |");
    CHECK(page.find("`kaneda1991`", table) != std::string::npos);
    CHECK(page.find("`perez1993`", table) == page.find("### perez1993", table));
}
