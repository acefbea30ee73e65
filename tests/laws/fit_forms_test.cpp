// Fits of the published forms: each finds a sky of its own form again, is used by its file for any air, and names what is wrong in it.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>

#include "atmosphere/presets.h"
#include "core/files.h"
#include "fit/dobashi1997.h"
#include "fit/hipiny2006.h"
#include "fit/hosek2012.h"
#include "fit/oneil2005.h"
#include "fit/perez1993.h"
#include "fit/perez_form.h"
#include "fit/preetham1999.h"
#include "fit/preetham_form.h"
#include "models/turbidity.h"
#include "tools/temporary_folder.h"

using namespace airlight;

namespace {

const std::vector<Wavelength> green = {550.0 * nm}, blue_and_red = {450.0 * nm, 650.0 * nm};
const JobStore nowhere("");

TruthSettings small_tables() {
    TruthSettings truth;
    truth.bake = {.sizes = {.transmittance_mu = 64, .transmittance_altitude = 32, .sun = 16, .azimuth = 4, .view = 12, .altitude = 10},
                  .orders = 3};
    return truth;
}

ModelOptions options_with(const std::filesystem::path& data) {
    ModelOptions options;
    options.data = data;
    options.bake = small_tables().bake;
    options.cache.enabled = false;
    return options;
}

// How far a model that reads `text` is from the tables, between the suns of the fits, and that it answers at `altitude` alone.
double from_the_tables(std::string_view model, const std::string& text, const Atmosphere& air, const std::vector<Wavelength>& wavelengths,
                       Length altitude, bool alone = true) {
    const test::TemporaryFolder folder;
    const ModelOptions options = options_with(folder.path / "fit.csv");
    REQUIRE(write_file(options.data, text));
    const auto sky = make_sky(model, air, wavelengths, options), truth = make_sky("tables", air, wavelengths, options);
    if (!sky) FAIL(sky.error().message());
    REQUIRE(truth);
    RelativeRms rms;
    for (const double sun_deg : {17.0, 53.0, 77.0})
        for (const FitDirection& d : fit_directions(sun_deg * deg, 6, 6)) {
            if (d.weight < 1.0) continue;
            const View view{altitude, d.direction.view_zenith, sun_deg * deg, d.direction.relative_azimuth};
            const auto seen = (*sky)->radiance(view), there = (*truth)->radiance(view);
            REQUIRE(seen);
            for (std::size_t w = 0; w < wavelengths.size(); ++w) rms.add(seen->radiance_W_m2_sr_nm[w], there->radiance_W_m2_sr_nm[w]);
        }
    if (alone) {
        CHECK(!(*sky)->radiance({altitude + 1.0 * m, 1.0, 1.0, 1.0}));
        if (altitude > 0.0 * m)
            CHECK((*sky)->radiance({0.0 * m, 1.0, 1.0, 1.0}).error().what ==
                  fmt::format("does not answer an eye at 0 m: its range is {0:g} to {0:g} m", altitude.in(m)));
    }
    CHECK((*sky)->transmittance(altitude, 0.5, 1e9 * m));
    return rms.value();
}

double worst(const Residuals& residuals) {
    double most = 0.0;
    for (const ResidualLine& line : residuals) most = std::max(most, line.relative_rms);
    return most;
}

// The text with its first `from` replaced.
std::string changed(std::string text, std::string_view from, std::string_view to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

template <class Parse>
void refuses(Parse parse, const std::string& text, std::string_view expected) {
    const auto result = parse(text, "f");
    REQUIRE(!result);
    const std::string said = result.error().message();
    CAPTURE(said);
    CHECK(said.substr(0, expected.size()) == expected);
}

std::vector<PerezSample> samples_of(const PerezForm& form, double sun_zenith) {
    std::vector<PerezSample> samples;
    for (const FitDirection& d : fit_directions(sun_zenith, 8, 8)) {
        const double mu = std::cos(d.direction.view_zenith),
                     nu = std::clamp(view_sun_cosine({0.0 * m, d.direction.view_zenith, sun_zenith, d.direction.relative_azimuth}), -1.0,
                                     1.0);
        samples.push_back({mu, nu, form.value(mu, nu), d.weight});
    }
    return samples;
}

// The paper's own coefficients [Preetham1999, app. A.2] as a file.
constexpr const char* published_preetham = R"(lowest_turbidity = 1.7
highest_turbidity = 10
quantity,coefficient,t2,t1,t0
Y,a,0,0.1787,-1.4630
Y,b,0,-0.3554,0.4275
Y,c,0,-0.0227,5.3251
Y,d,0,0.1206,-2.5771
Y,e,0,-0.0670,0.3703
Y,chi,0,-0.00833333333333333333,0.44444444444444444444
Y,tangent,0,4.0453,-4.9710
Y,even,0,-0.2155,2.4192
x,a,0,-0.0193,-0.2592
x,b,0,-0.0665,0.0008
x,c,0,-0.0004,0.2125
x,d,0,-0.0641,-0.8989
x,e,0,-0.0033,0.0452
x,z3,0.00166,-0.02903,0.11693
x,z2,-0.00375,0.06377,-0.21196
x,z1,0.00209,-0.03202,0.06052
x,z0,0,0.00394,0.25886
y,a,0,-0.0167,-0.2608
y,b,0,-0.0950,0.0092
y,c,0,-0.0079,0.2102
y,d,0,-0.0441,-1.6537
y,e,0,-0.0109,0.0529
y,z3,0.00275,-0.04214,0.15346
y,z2,-0.00610,0.08970,-0.26756
y,z1,0.00317,-0.04153,0.06670
y,z0,0,0.00516,0.26688
)";

}  // namespace

TEST_CASE("perez's form finds skies of its own again: clear, hazy, dark ones with a bright horizon") {
    const PerezForm forms[] = {
        {{-1.0, -0.32, 10.0, -3.0, 0.45}, 0.02}, {{-0.4, -0.6, 4.0, -2.0, 0.1}, 0.3}, {{-1.5, -0.42, 1.0, -1.5, 0.8}, 1e-5}};
    for (const double sun : {0.1, 0.9, 1.5}) {
        std::vector<std::vector<PerezSample>> suns;
        for (const PerezForm& form : forms) suns.push_back(samples_of(form, sun));
        const std::vector<PerezForm> fitted = fitted_perez(suns);
        for (std::size_t i = 0; i < suns.size(); ++i) {
            RelativeRms rms;
            for (const PerezSample& s : suns[i]) rms.add(fitted[i].value(s.mu, s.nu), s.value);
            CHECK(rms.value() < 5e-3);  // what the spring that holds flat directions leaves
        }
    }
    const PerezForm dark = fitted_perez(std::vector<std::vector<PerezSample>>{{{1.0, 0.5, 0.0, 1.0}, {0.5, 0.1, 0.0, 1.0}}})[0];
    CHECK(dark.value(0.7, 0.2) == 0.0);
}

TEST_CASE("preetham1999: the published coefficients as a file are the published sky") {
    const auto data = parse_preetham1999(published_preetham, "f");
    REQUIRE(data);
    for (const double t : {1.7, 3.0, 10.0})
        for (const double sun : {0.0, 0.8, 1.5}) {
            const f64::Preetham1999 read = in_text(*data, t, sun), text = f64::preetham1999(t, sun);
            for (const double mu : {1.0, 0.3})
                for (const double nu : {-0.4, 0.9}) {
                    const f64::ColourYxy a = f64::preetham1999_sky(read, mu, nu), b = f64::preetham1999_sky(text, mu, nu);
                    CHECK(a.luminance.value == doctest::Approx(b.luminance.value).epsilon(1e-12));
                    CHECK(a.x.value == doctest::Approx(b.x.value).epsilon(1e-12));
                    CHECK(a.y.value == doctest::Approx(b.y.value).epsilon(1e-12));
                }
        }
}

TEST_CASE("preetham's form finds the published sky again, over turbidities") {
    const auto data = parse_preetham1999(published_preetham, "f");
    REQUIRE(data);
    const std::vector<double> turbidities = {2.0, 4.0, 6.0};
    for (const bool luminance : {true, false}) {
        std::vector<PreethamSky> skies;
        for (const double t : turbidities)
            for (const double sun : {0.0, 0.5, 0.9, 1.2, 1.4}) {
                const f64::Preetham1999 sky = in_text(*data, t, sun);
                skies.push_back(
                    {t, sun,
                     samples_of(luminance ? PerezForm{sky.luminance, sky.scale.luminance.value} : PerezForm{sky.x, sky.scale.x.value},
                                sun)});
            }
        const std::vector<TurbidityPolynomial> fitted = fitted_preetham(skies, turbidities, luminance);
        Preetham1999Data again = *data;
        std::copy(fitted.begin(), fitted.end(), again.coefficients.begin() + (luminance ? 0 : 8));
        RelativeRms rms;
        for (const PreethamSky& sky : skies) {
            const f64::Preetham1999 text = in_text(again, sky.turbidity, sky.sun_zenith);
            for (const PerezSample& s : sky.samples) {
                const f64::ColourYxy c = f64::preetham1999_sky(text, s.mu, s.nu);
                rms.add((luminance ? c.luminance : c.x).value, s.value);
            }
        }
        CHECK(rms.value() < 1e-2);
    }
}

TEST_CASE("perez1993 fitted to hazy air, by its file") {
    Team team;
    const Atmosphere hazy = *preset("earth-hazy");
    const auto fit = fit_perez1993(hazy, blue_and_red, 0.0 * m, small_tables(), team, nowhere, {});
    REQUIRE(fit);
    CHECK(worst(fit->residuals) < 0.1);
    CHECK(from_the_tables("perez1993", perez1993_csv(fit->data, "#"), hazy, blue_and_red, 0.0 * m) < 0.1);
}

TEST_CASE("perez1993 fitted to Mars") {
    Team team;
    const Atmosphere mars = *preset("mars");
    const auto fit = fit_perez1993(mars, blue_and_red, 0.0 * m, small_tables(), team, nowhere, {});
    REQUIRE(fit);
    CHECK(worst(fit->residuals) < 0.2);
    CHECK(from_the_tables("perez1993", perez1993_csv(fit->data, "#"), mars, blue_and_red, 0.0 * m) < 0.2);
}

TEST_CASE("dobashi1997 fitted to the air 20 km up, all orders") {
    Team team;
    const Atmosphere clear = *preset("earth-clear");
    const auto fit = fit_dobashi1997(clear, green, {.error = 1e-5, .altitude = 20.0 * km}, small_tables(), team, nowhere, {});
    REQUIRE(fit);
    CHECK(worst(fit->residuals) < 0.03);
    CHECK(from_the_tables("dobashi1997", dobashi1997_csv(fit->data, "#"), clear, green, 20.0 * km) < 0.03);
}

TEST_CASE("hosek2012 fitted to the air 20 km up") {
    Team team;
    const Atmosphere clear = *preset("earth-clear");
    HosekFitSettings settings{{*turbidity(clear)}, {0.2}, green, 20.0 * km, small_tables()};
    const auto fit = fit_hosek2012(clear, settings, team, nowhere, {});
    REQUIRE(fit);
    CHECK(worst(fit->residuals) < 0.1);
    Atmosphere air = clear;
    air.ground_albedo = SpectrumOf<Number>::constant(0.2);
    CHECK(from_the_tables("hosek2012", hosek_csv(*fit, clear.name), air, green, 20.0 * km) < 0.1);
}

TEST_CASE("hipiny2006 fitted to two altitudes of hazy air, and used between them") {
    Team team;
    const Atmosphere hazy = *preset("earth-hazy");
    const auto fit = fit_hipiny2006(hazy, {{0.0, 20000.0}, {*turbidity(hazy)}, small_tables()}, team, nowhere, {});
    REQUIRE(fit);
    CHECK(fit->residuals.size() == 12);
    CHECK(worst(fit->residuals) < 0.15);
    const std::string text = hipiny2006_csv(fit->data, "#");
    const auto again = parse_hipiny2006(text, "f");
    REQUIRE(again);
    CHECK(again->patches == fit->data.patches);
    // Colours are daylight here, so that a wavelength is further off than luminance.
    for (const Length altitude : {0.0 * m, 20.0 * km}) CHECK(from_the_tables("hipiny2006", text, hazy, green, altitude, false) < 0.2);
}

TEST_CASE("preetham1999 fitted to hazy air of its own turbidity, and to a range of them") {
    Team team;
    const Atmosphere hazy = *preset("earth-hazy");
    const double own = *turbidity(hazy);
    for (const std::vector<double>& turbidities : {std::vector<double>{own}, {own, own + 2.0}}) {
        const auto fit = fit_preetham1999(hazy, {turbidities, 0.0 * m, small_tables()}, team, nowhere, {});
        REQUIRE(fit);
        CHECK(fit->residuals.size() == 6 * turbidities.size());
        // One form for all suns: nothing but the value in the zenith depends on the sun.
        CHECK(worst(fit->residuals) < 0.3);
        if (turbidities.size() == 1)
            CHECK(from_the_tables("preetham1999", preetham1999_csv(fit->data, "#"), hazy, green, 0.0 * m) < 0.3);
    }
}

TEST_CASE("oneil2005 by the file of its fit is oneil2005, on its own planet alone") {
    const test::TemporaryFolder folder;
    const Atmosphere mars = *preset("mars");
    const ONeilFit fit = fit_oneil2005(mars);
    CHECK(worst(fit.residuals) < 0.1);
    const ModelOptions options = options_with(folder.path / "fit.csv");
    REQUIRE(write_file(options.data, oneil2005_csv(fit.data, "#")));
    const auto by_file = make_sky("oneil2005", mars, green, options), by_itself = make_sky("oneil2005", mars, green);
    REQUIRE(by_file);
    for (const double view : {0.1, 1.2, 2.5}) {
        const View v{3.0 * km, view, 0.9, 0.4};
        CHECK((*by_file)->radiance(v)->radiance_W_m2_sr_nm[0] ==
              doctest::Approx((*by_itself)->radiance(v)->radiance_W_m2_sr_nm[0]).epsilon(1e-12));
    }
    const auto elsewhere = make_sky("oneil2005", *preset("earth-clear"), green, options);
    REQUIRE(!elsewhere);
    CHECK(elsewhere.error().what == "is fitted to a planet's radius of 3.3895e+06 m: that of earth-clear is 6.371e+06 m");
}

TEST_CASE("a damaged file of a fit is refused with its line") {
    const std::string perez =
        perez1993_csv({0.0, {450.0, 650.0}, {0.0, 90.0}, std::vector<PerezForm>(4, {{-1, -0.3, 2, -1, 0.3}, 1})}, "#");
    REQUIRE(parse_perez1993(perez, "f"));
    refuses(parse_perez1993, changed(perez, "450,90,-1,-0.3", "450,90,-1,0.3"), "f:4: b = 0.3 is out of range: it must be 0 or less");
    refuses(parse_perez1993, changed(perez, "650,0,", "651,0,"), "f:6: wavelength_nm = 650 is out of order: it must be 651");
    refuses(parse_perez1993, changed(perez, "650,90,", "650,95,"), "f:6: sun_zenith_deg = 95 is out of order: it must be 90");
    refuses(parse_perez1993, changed(perez, "650,90,-1", "650,90,inf"), "f:6: a = \"inf\" is not a finite number");
    refuses(parse_perez1993, perez.substr(0, perez.rfind("650,90")), "f:5: has 3 rows for 2 wavelengths and 2 suns: it must have 4");
    refuses(parse_perez1993, "altitude_m = -1\n" + perez, "f:1: altitude_m = -1 is out of range");

    refuses(parse_preetham1999, changed(published_preetham, "x,b,0,-0.0665,0.0008", "x,b,0,0.0665,0.0008"),
            "f:13: b is 0.11385 at turbidity 1.7, out of range");
    refuses(parse_preetham1999, changed(published_preetham, "0.44444444444444444444", "0.6"), "f:9: chi is 0.585833 at turbidity 1.7");
    refuses(parse_preetham1999, changed(published_preetham, "x,a,", "x,f,"), "f:12: x,f is out of order: it must be x,a");
    refuses(parse_preetham1999, changed(published_preetham, "lowest_turbidity = 1.7\n", ""), "f: does not state lowest_turbidity");
    refuses(parse_preetham1999, changed(published_preetham, "highest_turbidity = 10", "highest_turbidity = 1"),
            "f:2: highest_turbidity = 1 is out of range: it must be a number from 1.7 to 1000");
    refuses(parse_preetham1999, changed(published_preetham, "y,z0,0,0.00516,0.26688\n", ""), "f:28: has 25 rows: it must have 26");

    const std::string oneil = oneil2005_csv({6.371e6, {8000.0, {1, 2, 3, 4, 5}}, {1200.0, {1, 2, 3, 4, 5}}}, "#");
    REQUIRE(parse_oneil2005(oneil, "f"));
    refuses(parse_oneil2005, changed(oneil, "aerosol,1200", "aerosol,-1200"), "f:5: scale_height_m = -1200 is out of range");
    refuses(parse_oneil2005, changed(oneil, "aerosol,", "dust,"), "f:5: constituent = \"dust\" is out of order: it must be aerosol");
    refuses(parse_oneil2005, oneil.substr(0, oneil.find("aerosol")), "f:4: has no row of aerosol");
    refuses(parse_oneil2005, changed(oneil, "bottom_radius_m = 6371000\n", ""), "f: does not state bottom_radius_m");
}

TEST_CASE("a fitted file has what it is for: other options beside it are refused, and so is a wavelength outside") {
    const test::TemporaryFolder folder;
    ModelOptions options = options_with(folder.path / "fit.csv");
    REQUIRE(write_file(options.data,
                       perez1993_csv({0.0, {450.0, 650.0}, {0.0, 90.0}, std::vector<PerezForm>(4, {{-1, -0.3, 2, -1, 0.3}, 1})}, "#")));
    CHECK(make_sky("perez1993", *preset("earth-clear"), {700.0 * nm}, options).error().what ==
          "does not answer 700 nm: its data is for 450 to 650 nm");
    options.clearness = 3.0;
    CHECK(make_sky("perez1993", *preset("earth-clear"), green, options).error().what ==
          "takes no clearness and no brightness beside a fitted file");
    options.clearness = {};
    REQUIRE(write_file(options.data, published_preetham));
    CHECK(make_sky("preetham1999", *preset("earth-clear"), green, options).error().what ==
          "does not answer a turbidity of 1.32, which is that of earth-clear: its range is 1.7 to 10");
    options.turbidity = 3.0;
    const auto sky = make_sky("preetham1999", *preset("earth-clear"), green, options);
    REQUIRE(sky);
    CHECK((*sky)->aerial_perspective({0.0 * m, 1.0, 1.0, 0.0}, 1.0 * km).error().what == "has no aerial perspective with a fitted file");
}
