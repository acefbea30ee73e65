// dobashi1997: its functions, how many a sky takes, their file, and the sky they came from.

#include <doctest/doctest.h>

#include <cmath>

#include "atmosphere/presets.h"
#include "core/files.h"
#include "core/quadrature.h"
#include "models/dobashi1997_series.h"
#include "models/model.h"
#include "physics/models/f64.h"
#include "tools/temporary_folder.h"

using namespace airlight;

namespace {

constexpr int azimuths = 64;
double azimuth(int k) { return pi * (k + 0.5) / azimuths; }

template <class F>
std::vector<double> around(F f) {
    std::vector<double> radiances;
    for (int k = 0; k < azimuths; ++k) radiances.push_back(f(azimuth(k)));
    return radiances;
}

double sum_of(const std::vector<double>& factors, double azimuth) {
    double sum = 0.0;
    for (std::size_t i = 0; i < factors.size(); ++i) sum += factors[i] * std::cos(static_cast<double>(i) * azimuth);
    return sum;
}

// What a series leaves of a band, summed and not by Parseval's equation.
double rest(const std::vector<double>& radiances, const std::vector<double>& factors) {
    double difference = 0.0, square = 0.0;
    for (int k = 0; k < azimuths; ++k) {
        const double l = radiances[static_cast<std::size_t>(k)];
        difference += std::pow(l - sum_of(factors, azimuth(k)), 2);
        square += l * l;
    }
    return difference / square;
}

// A peak at azimuth 0, the narrower the larger k.
auto peak(double k) {
    return [k](double a) { return 1.0 + 5.0 * std::exp(k * (std::cos(a) - 1.0)); };
}

// A sky of few functions at every sun.
double few_functions(const View& v) {
    const double mu = std::cos(v.view_zenith), sine = std::sin(v.view_zenith);
    return 1.0 + 0.4 * mu * mu + 0.3 * sine * std::cos(v.relative_azimuth) + 0.1 * sine * sine * std::cos(2.0 * v.relative_azimuth);
}

const std::vector<Wavelength> green = {550.0 * nm};

template <class F>
Dobashi1997Data series_of(SkyBasis basis, F sky) {
    const Dobashi1997Settings settings{.basis = basis, .error = 1e-14};
    std::vector<double> radiances;
    for (const View& v : dobashi1997_views(settings)) radiances.push_back(sky(v));
    return dobashi1997_series(radiances, green, settings);
}

double radiance_of(const Sky& sky, const View& view) {
    const Result<RadianceEstimate> seen = sky.radiance(view);
    REQUIRE(seen);
    return seen->radiance_W_m2_sr_nm[0];
}

std::unique_ptr<Sky> clear_sky(const std::string& key, const ModelOptions& options = {}) {
    Result<std::unique_ptr<Sky>> sky = make_sky(key, *preset("earth-clear"), green, options);
    REQUIRE(sky);
    return std::move(*sky);
}

std::string file_of(const Dobashi1997Data& data) { return dobashi1997_csv(data, "# a sky"); }

// The text with its first `from` replaced.
std::string changed(std::string text, std::string_view from, std::string_view to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("dobashi1997: the recurrence sums cosines as they are, to the peaks at either end") {
    const std::vector<double> factors = {2.0, -0.7, 0.5, 0.0, 0.3, -0.2, 0.1};
    for (const double a : {0.0, 1e-9, 0.3, 1.5, 1.6, 2.9, pi}) {
        f64::CosineSum sum = f64::cosine_sum(a);
        for (std::size_t i = factors.size(); i-- > 1;) sum = f64::cosine_term(sum, factors[i]);
        CHECK(f64::cosine_series(sum, factors[0]).value == doctest::Approx(sum_of(factors, a)).epsilon(1e-14));
    }
}

TEST_CASE("dobashi1997: Legendre's functions of one order are orthogonal, and of norm one") {
    const GaussRule rule = gauss_rule(32, -1.0, 1.0);
    for (const int order : {0, 1, 2, 7, 20})
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) {
                double product = 0.0;
                for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
                    const std::vector<double> functions = legendre_functions(order, order + 4, rule.nodes[k]);
                    product += rule.weights[k] * functions[i] * functions[j];
                }
                CHECK(product == doctest::Approx(i == j ? 1.0 : 0.0).epsilon(1e-12));
            }
    // sqrt(5 / 2) (3 mu^2 - 1) / 2 and sqrt(15 / 16) (1 - mu^2)
    CHECK(legendre_functions(0, 2, 0.6)[1] == doctest::Approx(std::sqrt(2.5) * 0.04).epsilon(1e-12));
    CHECK(legendre_functions(2, 2, 0.6)[0] == doctest::Approx(std::sqrt(15.0 / 16.0) * 0.64).epsilon(1e-12));
}

TEST_CASE("dobashi1997: a band of a few cosines has these factors and no more") {
    const std::vector<double> factors =
        cosine_factors(around([](double a) { return 2.0 + 0.5 * std::cos(a) - 0.25 * std::cos(3.0 * a); }), 1e-12, 64);
    REQUIRE(factors.size() == 4);
    const double expected[] = {2.0, 0.5, 0.0, -0.25};
    for (std::size_t i = 0; i < 4; ++i) CHECK(std::abs(factors[i] - expected[i]) < 1e-14);
    CHECK(cosine_factors(around([](double) { return 3.0; }), 1e-4, 64).size() == 1);
    CHECK(cosine_factors(around([](double) { return 0.0; }), 1e-4, 64) == std::vector<double>{0.0});
}

TEST_CASE("dobashi1997: the error falls with every function, and a band takes the fewest that reach the demanded one") {
    std::size_t before = 0;
    for (const double k : {1.0, 10.0, 100.0}) {
        const std::vector<double> radiances = around(peak(k));
        double last = 1.0;
        for (int count = 1; count <= azimuths; ++count) {
            const std::vector<double> factors = cosine_factors(radiances, 0.0, count);
            const double error = cosine_error(radiances, factors);
            CHECK(std::abs(error - rest(radiances, factors)) < 1e-13);
            CHECK(error <= last + 1e-14);
            last = error;
        }
        CHECK(last < 1e-13);  // as many functions as samples leave nothing
        for (const double demanded : {1e-2, 1e-4, 1e-6}) {
            const std::vector<double> factors = cosine_factors(radiances, demanded, azimuths);
            CHECK(rest(radiances, factors) <= demanded);
            CHECK(rest(radiances, {factors.begin(), factors.end() - 1}) > demanded);
        }
        const std::size_t count = cosine_factors(radiances, 1e-4, azimuths).size();
        CHECK(count > before);  // a narrower peak takes more
        before = count;
    }
}

TEST_CASE("dobashi1997: a sky of few functions is reproduced: everywhere by harmonics, in its bands by cosines, on its grid by samples") {
    const Dobashi1997Data harmonics = series_of(SkyBasis::harmonics, few_functions), cosines = series_of(SkyBasis::cosines, few_functions),
                          samples = series_of(SkyBasis::samples, few_functions);
    CHECK(harmonics.at(0, 3)[0].size() == 2);  // degrees 0 and 2
    CHECK(harmonics.at(0, 3)[1].size() == 1);
    CHECK(harmonics.at(0, 3)[2].size() == 1);
    CHECK(harmonics.at(0, 3)[3].empty());
    CHECK(cosines.at(0, 3)[8].size() == 3);
    for (const double sun_deg : {0.0, 22.0, 84.7, 90.0})
        for (const double a : {0.0, 1.0, 2.5}) {
            for (const double view_deg : {0.0, 3.0, 47.0, 90.0}) {
                const View v{0.0 * m, view_deg * deg, sun_deg * deg, a};
                CHECK(harmonics.radiance(0, v) == doctest::Approx(few_functions(v)).epsilon(1e-12));
            }
            for (const double view_deg : {0.0, 45.0, 83.0}) {
                const View v{0.0 * m, view_deg * deg, sun_deg * deg, a}, node{0.0 * m, view_deg * deg, sun_deg * deg, 0.5 * pi};
                CHECK(cosines.radiance(0, v) == doctest::Approx(few_functions(v)).epsilon(1e-12));
                CHECK(samples.radiance(0, node) == doctest::Approx(few_functions(node)).epsilon(1e-12));
            }
        }
    // Between two bands and two azimuths a mean remains.
    const View half{0.0 * m, 47.5 * deg, 0.4, 0.5 * pi}, low{0.0 * m, 45.0 * deg, 0.4, 0.5 * pi}, high{0.0 * m, 50.0 * deg, 0.4, 0.5 * pi};
    const double mean = 0.5 * (few_functions(low) + few_functions(high));
    CHECK(cosines.radiance(0, half) == doctest::Approx(mean).epsilon(1e-12));
    CHECK(samples.radiance(0, half) == doctest::Approx(mean).epsilon(1e-12));
}

TEST_CASE("dobashi1997: harmonics end at the degree that the demanded error needs, or at the most") {
    // Narrower than degree 20 can follow, as the paper says of the sun's surroundings.
    const auto glow = [](double width) {
        return [width](const View& v) { return 1.0 + 20.0 * std::exp(width * (view_sun_cosine(v) - 1.0)); };
    };
    const auto degrees = [&](double width, double error) {
        const Dobashi1997Settings settings{.basis = SkyBasis::harmonics, .error = error};
        std::vector<double> radiances;
        for (const View& v : dobashi1997_views(settings)) radiances.push_back(glow(width)(v));
        const BandSeries series = dobashi1997_series(radiances, green, settings).at(0, 10);  // the sun at 50 deg
        std::size_t functions = 0;
        for (const auto& order : series) functions += order.size();
        return functions;
    };
    CHECK(degrees(1.0, 1e-2) < degrees(1.0, 1e-4));
    CHECK(degrees(1.0, 1e-3) < degrees(5.0, 1e-3));
    CHECK(degrees(300.0, 1e-4) == 121);  // of degrees 0 to 20, with orders that are even with them
}

TEST_CASE("dobashi1997: in its bands, at its suns, the sky is that of kaneda1991 but for the demanded error") {
    const auto source = clear_sky("kaneda1991"), sky = clear_sky("dobashi1997");
    for (const double sun_deg : {30.0, 80.0})
        for (const double view_deg : {10.0, 30.0, 80.0}) {
            double difference = 0.0, square = 0.0;
            for (int k = 0; k < azimuths; ++k) {
                const View view{0.0 * m, view_deg * deg, sun_deg * deg, azimuth(k)};
                difference += std::pow(radiance_of(*sky, view) - radiance_of(*source, view), 2);
                square += std::pow(radiance_of(*source, view), 2);
            }
            CHECK(difference <= 1.0001e-4 * square);
        }
}

TEST_CASE("dobashi1997: three forms of one sky, it is the same on both sides of the sun, and in domes") {
    const auto source = clear_sky("oneil2005");  // the fastest
    const test::TemporaryFolder folder;
    ModelOptions options;
    options.data = folder.path / "sky.csv";
    const View view{0.0 * m, 62.0 * deg, 47.0 * deg, 2.0};
    for (const SkyBasis basis : {SkyBasis::cosines, SkyBasis::samples, SkyBasis::harmonics}) {
        CAPTURE(name_of(basis));
        const Result<Dobashi1997Data> data = dobashi1997_series(*source, {.basis = basis}, {});
        REQUIRE(data);
        if (basis == SkyBasis::cosines) {
            CHECK(data->at(0, 16)[16].size() > 2 * data->at(0, 16)[4].size());  // a sun at 80 deg: its own band, and the one at 20
            CHECK(data->at(0, 0)[10].size() == 1);                              // a sun in the zenith
        }
        REQUIRE(write_file(options.data, file_of(*data)));
        options.variant = name_of(basis);
        const auto sky = clear_sky("dobashi1997", options);
        // Away from the sun, between two of everything. Harmonics spread what they cannot follow around the sun over the sky.
        CHECK(radiance_of(*sky, view) == doctest::Approx(radiance_of(*source, view)).epsilon(basis == SkyBasis::harmonics ? 0.1 : 0.01));
        for (const double a : {-2.0, 2.0 * pi - 2.0, 2.0 + 4.0 * pi}) {
            View turned = view;
            turned.relative_azimuth = a;
            CHECK(radiance_of(*sky, turned) == doctest::Approx(radiance_of(*sky, view)).epsilon(1e-12));
        }
        const auto dome = sky->dome(0.0 * m, view.sun_zenith);
        REQUIRE(dome);
        float seen = 0.0f;
        (*dome)->radiance(view.view_zenith, view.relative_azimuth, {&seen, 1});
        CHECK(static_cast<double>(seen) == doctest::Approx(radiance_of(*sky, view)).epsilon(1e-6));
        (*dome)->radiance(1.7, 0.0, {&seen, 1});
        CHECK(seen == 0.0f);
    }
}

TEST_CASE("dobashi1997: a file answers as the series it was written of, at its altitude alone") {
    const test::TemporaryFolder folder;
    ModelOptions options;
    options.data = folder.path / "sky.csv";
    for (const SkyBasis basis : {SkyBasis::cosines, SkyBasis::samples, SkyBasis::harmonics}) {
        Dobashi1997Data data = series_of(basis, few_functions);
        data.altitude_m = 20000.0;
        REQUIRE(write_file(options.data, file_of(data)));
        const auto sky = clear_sky("dobashi1997", options);
        const View view{20.0 * km, 0.9, 0.7, 1.1};
        CHECK(radiance_of(*sky, view) == doctest::Approx(data.radiance(0, view)).epsilon(1e-5));  // six digits
        const auto refusal = [&](View v) { return sky->radiance(v).error().what; };
        CHECK(refusal({0.0 * m, 0.9, 0.7, 1.1}) == "does not answer an eye at 0 m: its range is 20000 to 20000 m");
        CHECK(refusal({20.0 * km, 0.9, 91.0 * deg, 1.1}) == "does not answer a sun zenith angle of 91 deg: its range is 0 to 90 deg");
        CHECK(refusal({20.0 * km, 91.0 * deg, 0.7, 1.1}) == "does not answer a view zenith angle of 91 deg: its range is 0 to 90 deg");
    }
    options.variant = "cosines";
    CHECK(make_sky("dobashi1997", *preset("earth-clear"), green, options).error().what == "holds harmonics, not cosines");
    options.variant = "waves";
    CHECK(make_sky("dobashi1997", *preset("earth-clear"), green, options).error().what ==
          "\"waves\" is no basis: they are cosines, samples, harmonics");
    options.variant = "";
    CHECK(make_sky("dobashi1997", *preset("earth-clear"), {600.0 * nm}, options).error().what ==
          "does not answer 600 nm: its data is for 550 to 550 nm");
}

TEST_CASE("dobashi1997: a damaged file is refused with its line") {
    const std::string text = file_of(series_of(SkyBasis::cosines, few_functions));
    REQUIRE(parse_dobashi1997(text, "f"));
    const auto complaint = [](const std::string& damaged) { return parse_dobashi1997(damaged, "f").error().message(); };
    const auto starts = [&](const std::string& damaged, std::string_view expected) {
        const std::string said = complaint(damaged);
        CAPTURE(said);
        CHECK(said.substr(0, expected.size()) == expected);
    };
    starts("", "f: has no line that names its columns");
    starts(changed(text, "basis = cosines", "basis = waves"), "f: \"waves\" is no basis");
    starts(changed(text, "basis = cosines", "base = cosines"), "f:2: \"base\" is nothing that this file may state");
    starts(changed(text, "basis = cosines", "basis = cosines\nbasis = cosines"), "f:3: basis is stated twice");
    starts(changed(text, "basis = cosines", "basis = cosines\naltitude_m = high"), "f:3: altitude_m = high is out of range");
    starts(changed(text, "wavelength_nm,", "wave,"), "f:3: the columns are");
    starts(changed(text, "550,0,5,", "550,0,x,"), "f:5: band = \"x\" is not a finite number");
    starts(changed(text, "550,0,10,", "550,0,11,"), "f:27: band = 10 is out of order: it must be 11");
    starts(changed(text, "550,5,0,", "550,95,0,"), "f:25: sun_zenith_deg = 95 is out of range: it must be 0 to 90");
    starts(changed(text, "550,0,0,", "550,0,0,nan "), "f:4: factors: \"nan\" is not a finite number");
    starts(text.substr(0, text.rfind("550,90,90")), "f:443: has 440 rows for 1 wavelengths, 21 suns and 21 bands: it must have 441");
    const std::string grid = file_of(series_of(SkyBasis::samples, few_functions));
    starts(changed(grid, "550,0,5,", "550,0,5,1 "), "f:5: has 38 samples: it must have 37");
}
