// Models that march through exponential air, and closed forms in constant air: their limits, their closed forms, and the
// reference restricted to one order.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>

#include "models/model.h"
#include "models/scale_function_fit.h"
#include "models/sea.h"
#include "transport/reference.h"

using namespace airlight;

namespace {

SpectrumOf<InverseLength> falling(double at_550, double power) {
    std::vector<SpectrumOf<InverseLength>::Sample> samples;
    for (const double w : {360.0, 450.0, 550.0, 650.0, 830.0}) samples.push_back({w * nm, at_550 * std::pow(550.0 / w, power) * per_m});
    return *SpectrumOf<InverseLength>::of(samples);
}

// Two exponential constituents, `dense` times as dense as the clear Earth's; no ground.
Atmosphere earth(double dense = 1.0, double albedo = 0.0) {
    Atmosphere a{.name = "two exponentials",
                 .bottom_radius = 6360.0 * km,
                 .top_altitude = 60.0 * km,
                 .constituents = {},
                 .ground_albedo = SpectrumOf<Number>::constant(albedo),
                 .sun = {}};
    a.constituents = {{"air", ExponentialProfile{8.0 * km}, falling(1.2e-5 * dense, 4.0), falling(0.0, 0.0), RayleighPhase{}},
                      {"haze", ExponentialProfile{1.2 * km}, falling(5e-5 * dense, 1.3), falling(5e-6 * dense, 1.3),
                       HenyeyGreensteinPhase{SpectrumOf<Number>::constant(0.7)}}};
    a.sun.irradiance = SpectrumOf<SpectralIrradiance>::constant(1.5 * W_per_m2_nm);
    return a;
}

const std::vector<Wavelength> wavelengths = {450.0 * nm, 550.0 * nm, 650.0 * nm};

std::unique_ptr<Sky> sky_of(std::string_view key, const Atmosphere& atmosphere, const ModelOptions& options = {}) {
    Result<std::unique_ptr<Sky>> sky = make_sky(key, atmosphere, wavelengths, options);
    REQUIRE(sky);
    return std::move(*sky);
}

double radiance(const Sky& sky, const View& view, std::size_t w = 1) {
    const auto seen = sky.radiance(view);
    REQUIRE(seen);
    return seen->radiance_W_m2_sr_nm[w];
}

const std::vector<const char*> marched = {"kaneda1991", "nishita1993", "dobashi2002", "oneil2004", "oneil2005"};
const std::vector<const char*> all = {"nishita1996", "fog",         "klassen1987", "kaneda1991", "nishita1993",
                                      "hoffman2002", "dobashi2002", "nielsen2003", "oneil2004",  "oneil2005"};

// The largest relative error against the reference's first order over views from an eye.
double worst_against_one_order(const Sky& sky, const Reference& reference, Length eye, const std::vector<View>& views) {
    double worst = 0.0;
    for (View view : views) {
        view.altitude = eye;
        const auto exact = reference.radiance(view, {.paths = 2048, .last_order = 1});
        REQUIRE(exact);
        for (std::size_t w = 0; w < wavelengths.size(); ++w) {
            const double truth = exact->radiance_W_m2_sr_nm[w], noise = 3.0 * exact->standard_error[w];
            const double error = std::abs(radiance(sky, view, w) - truth) - noise;
            if (truth > 1e-6) worst = std::max(worst, error / truth);
        }
    }
    return worst;
}

}  // namespace

TEST_CASE("marched models are the reference's first order, from the ground to space and into twilight") {
    const Atmosphere air = earth();
    const Result<Reference> reference = Reference::of(air, wavelengths);
    REQUIRE(reference);
    std::vector<View> up, down;
    for (const double sun : {20.0, 75.0, 89.0, 93.0})
        for (const double zenith : {0.0, 60.0, 85.0, 89.0}) up.push_back({0.0 * m, zenith * deg, sun * deg, 60.0 * deg});
    // From 400 km the horizon stands at 109.8 degrees.
    for (const double sun : {20.0, 75.0, 89.0})
        for (const double zenith : {180.0, 130.0, 108.0}) down.push_back({0.0 * m, zenith * deg, sun * deg, 120.0 * deg});
    // Nishita's sunlight is linear between cylinders, though its depth has a root's edge where a cylinder touches the sample's sphere:
    // the sun at the horizon of an eye at 8 km. O'Neil's samples are too few for a bound.
    struct Bound {
        const char* key;
        double ground, flight, space;
    };
    for (const Bound& bound :
         {Bound{"kaneda1991", 0.003, 0.003, 0.003}, Bound{"nishita1993", 0.04, 0.13, 0.06}, Bound{"dobashi2002", 0.003, 0.003, 0.003}}) {
        CAPTURE(bound.key);
        const auto sky = sky_of(bound.key, air);
        const double ground = worst_against_one_order(*sky, *reference, 0.0 * m, up);
        const double flight = worst_against_one_order(*sky, *reference, 8.0 * km, up);
        const double space = worst_against_one_order(*sky, *reference, 400.0 * km, down);
        fmt::print("  {}: within {:.4f} on the ground, {:.4f} at 8 km, {:.4f} from space\n", bound.key, ground, flight, space);
        CHECK(ground < bound.ground);
        CHECK(flight < bound.flight);
        CHECK(space < bound.space);
    }
}

TEST_CASE("as the air thins, the zenith is as bright as its column, its phase function and the sun say") {
    const double thin = 1e-3;
    const View view{0.0 * m, 0.0, 40.0 * deg, 0.0};
    const double air = 1.2e-5 * thin * 8000.0 * -std::expm1(-7.5), haze = 5e-5 * thin * 1200.0;
    const double nu = std::cos(40.0 * deg);
    const double expected = 1.5 * (air * phase_value(RayleighPhase{}, nu, 550.0 * nm).value +
                                   haze * phase_value(HenyeyGreensteinPhase{SpectrumOf<Number>::constant(0.7)}, nu, 550.0 * nm).value);
    // Sums of 48 or more samples, and the depth itself (3e-4).
    for (const char* key : {"kaneda1991", "nishita1993", "dobashi2002", "hoffman2002"}) {
        CAPTURE(key);
        CHECK(radiance(*sky_of(key, earth(thin)), view) == doctest::Approx(expected).epsilon(0.01));
    }
}

TEST_CASE("Beer and Lambert: what comes through two legs is the product of the legs") {
    for (const char* key : {"kaneda1991", "nishita1993", "dobashi2002", "oneil2004", "oneil2005", "klassen1987"}) {
        CAPTURE(key);
        const auto sky = sky_of(key, earth());
        // Straight up the legs are easy to place.
        const double whole = (*sky->transmittance(500.0 * m, 0.0, 4500.0 * m))[1];
        const double legs = (*sky->transmittance(500.0 * m, 0.0, 1000.0 * m))[1] * (*sky->transmittance(1500.0 * m, 0.0, 3500.0 * m))[1];
        // Each march has its own samples; O'Neil's table is linear between altitudes 470 m apart.
        CHECK(whole == doctest::Approx(legs).epsilon(0.004));
        CHECK(whole < (*sky->transmittance(500.0 * m, 0.0, 1000.0 * m))[1]);
    }
}

TEST_CASE("transmittance to space is the exponential of the column") {
    const double depth = 1.2e-5 * 8000.0 * -std::expm1(-7.5) + 5.5e-5 * 1200.0;
    for (const char* key : {"kaneda1991", "nishita1993", "dobashi2002", "oneil2004", "oneil2005", "klassen1987", "hoffman2002"}) {
        CAPTURE(key);
        // O'Neil's polynomial is off by a tenth of the aerosol's depth in the zenith: see its fit.
        const double bound = std::string(key) == "oneil2005" ? 0.02 : 0.006;
        CHECK((*sky_of(key, earth())->transmittance(0.0 * m, 0.0, 1e9 * m))[1] == doctest::Approx(std::exp(-depth)).epsilon(bound));
    }
}

TEST_CASE("aerial perspective over all of the air is the sky, and over nothing is clear") {
    for (const char* key : all) {
        CAPTURE(key);
        const auto sky = sky_of(key, earth());
        const View view{0.0 * m, 60.0 * deg, 50.0 * deg, 70.0 * deg};
        const auto through = sky->aerial_perspective(view, 1e9 * m), none = sky->aerial_perspective(view, 0.0 * m);
        REQUIRE(through);
        REQUIRE(none);
        CHECK(through->inscattered_W_m2_sr_nm[1] == doctest::Approx(radiance(*sky, view)).epsilon(1e-9));
        CHECK(none->inscattered_W_m2_sr_nm[1] == 0.0);
        CHECK(none->transmittance[1] == 1.0);
        const auto near = sky->aerial_perspective(view, 2.0 * km), far = sky->aerial_perspective(view, 20.0 * km);
        CHECK(far->transmittance[1] < near->transmittance[1]);
        CHECK(far->inscattered_W_m2_sr_nm[1] > near->inscattered_W_m2_sr_nm[1]);
    }
}

TEST_CASE("no model answers with a negative or infinite radiance, nor beyond its range") {
    for (const char* key : all) {
        CAPTURE(key);
        const auto sky = sky_of(key, earth(3.0, 0.3));
        const ModelCard& card = find_model(key)->card;
        for (const double altitude : {0.0, 10.0, 2000.0, 30e3, 59e3, 400e3, 4e7})
            for (const double sun : {0.0, 60.0, 90.0, 95.0, 108.0, 180.0})
                for (const double zenith : {0.0, 45.0, 89.9, 90.0, 91.0, 109.0, 120.0, 180.0}) {
                    CAPTURE(altitude);
                    CAPTURE(sun);
                    CAPTURE(zenith);
                    const auto seen = sky->radiance({altitude * m, zenith * deg, sun * deg, 0.3});
                    const bool inside =
                        altitude * m <= card.highest_eye && sun <= card.highest_sun_zenith_deg && zenith <= card.highest_view_zenith_deg;
                    // A card may say that within its ranges some views are refused.
                    if (card.refused.empty() || !inside) CHECK(static_cast<bool>(seen) == inside);
                    if (!seen) continue;
                    for (const double value : seen->radiance_W_m2_sr_nm) {
                        CHECK(std::isfinite(value));
                        CHECK(value >= 0.0);
                    }
                }
    }
}

TEST_CASE("nielsen2003 answers down to the horizontal, and the ground, but not the sky between") {
    const auto sky = sky_of("nielsen2003", earth(3.0, 0.3));
    const auto at_30km = [&](double zenith_deg) { return bool(sky->radiance({30.0 * km, zenith_deg * deg, 50.0 * deg, 0.3})); };
    CHECK(at_30km(90.0));
    CHECK(!at_30km(92.0));  // the horizon dips by 5.5 degrees
    CHECK(at_30km(97.0));
}

TEST_CASE("the closed form of constant air is the integral over it") {
    const auto sky = sky_of("hoffman2002", earth());
    const View view{0.0 * m, 85.0 * deg, 50.0 * deg, 30.0 * deg};
    const double length = 8000.0, beta = 1.2e-5 + 5.5e-5;
    const auto air = *sky->aerial_perspective(view, length * m);
    CHECK(air.transmittance[1] == doctest::Approx(std::exp(-beta * length)).epsilon(1e-12));
    // In-scattering grows with the distance as what comes through from there: the sum of thin slices.
    const double slice = 1.0;
    const double first = (*sky->aerial_perspective(view, slice * m)).inscattered_W_m2_sr_nm[1] / (1.0 - 0.5 * beta * slice);
    double sum = 0.0;
    for (int i = 0; i < 8000; ++i) sum += first * std::exp(-beta * (i + 0.5) * slice);
    CHECK(air.inscattered_W_m2_sr_nm[1] == doctest::Approx(sum).epsilon(1e-6));
}

TEST_CASE("fog: nothing scatters where there is none, linear and exponential fog let the same through in the mean") {
    const auto clear = sky_of("fog", earth(1e-12));
    const View view{0.0 * m, 89.0 * deg, 50.0 * deg, 30.0 * deg};
    CHECK((*clear->aerial_perspective(view, 100.0 * km)).transmittance[1] == doctest::Approx(1.0).epsilon(1e-9));
    CHECK((*clear->aerial_perspective(view, 100.0 * km)).inscattered_W_m2_sr_nm[1] < 1e-9);
    const auto straight = sky_of("fog", earth(), {.variant = "linear"}), curved = sky_of("fog", earth());
    double sums[2] = {0.0, 0.0};
    for (double s = 50.0; s < 300e3; s += 100.0) {
        sums[0] += 100.0 * (*straight->transmittance(0.0 * m, 89.9 * deg, s * m))[1];
        sums[1] += 100.0 * (*curved->transmittance(0.0 * m, 89.9 * deg, s * m))[1];
    }
    CHECK(sums[0] == doctest::Approx(1.0 / 6.7e-5).epsilon(1e-4));
    CHECK(sums[1] == doctest::Approx(sums[0]).epsilon(1e-3));
    CHECK((*straight->transmittance(0.0 * m, 89.9 * deg, 40.0 * km))[1] < 1e-300);
}

TEST_CASE("O'Neil's scale function, fitted to O'Neil's planet, is his polynomial") {
    // Air as deep as a fortieth of the radius, mean density at a quarter of it. [ONeil2005]
    const ScaleFunctionFit fit = fit_scale_function(10.0 * m, 0.25 * m, 0.0625 * m);
    for (int i = 0; i <= 10; ++i) {
        const double x = 0.1 * i;
        const double published = -0.00287 + x * (0.459 + x * (3.83 + x * (-6.80 + x * 5.25)));
        double ours = 0.0;
        for (int k = 4; k >= 0; --k) ours = ours * x + fit.coefficients[static_cast<std::size_t>(k)];
        CAPTURE(x);
        CHECK(std::abs(ours - published) < 0.06);
    }
    CHECK(fit.mean_residual < 0.02);
    CHECK(fit.worst_residual < 0.08);
}

TEST_CASE("the scale function is fitted to any planet, the thinner the air beside the planet, the worse the polynomial") {
    const auto residual = [](double radius_km, double scale_height_km) {
        return fit_scale_function(radius_km * km, 8.0 * scale_height_km * km, scale_height_km * km).mean_residual;
    };
    CHECK(residual(3390.0, 11.0) < 0.03);                   // Mars
    CHECK(residual(6360.0, 8.0) < 0.05);                    // the Earth's air
    CHECK(residual(6360.0, 1.2) < 0.12);                    // its aerosol
    CHECK(residual(2575.0, 40.0) < residual(6360.0, 1.2));  // Titan
}

TEST_CASE("more of the sea's light is blue than of the ground's, and it mirrors the sky at the horizon") {
    const auto sea = sky_of("nishita1993", earth(), {.variant = "sea"});
    const View down{400.0 * km, 180.0 * deg, 30.0 * deg, 0.0};
    const auto perspective = *sea->aerial_perspective(down, 1e9 * m);
    const auto water = [&](std::size_t w) { return radiance(*sea, down, w) - perspective.inscattered_W_m2_sr_nm[w]; };
    CHECK(water(0) > 4.0 * water(2));
    // As a reflectance: some percent in the blue, the mirrored sky in the red.
    const double reflected = water(0) * pi / (1.5 * std::cos(30.0 * deg) * perspective.transmittance[0]);
    CHECK(reflected > 0.01);
    CHECK(reflected < 0.12);
    CHECK(f64::sea_reflectance(1.0).value == doctest::Approx(std::pow(0.34 / 2.34, 2)));
    CHECK(f64::sea_reflectance(0.0).value == doctest::Approx(1.0));
}

TEST_CASE("nishita1996 answers by day: not in twilight, nor from space where it is night") {
    const auto sky = sky_of("nishita1996", earth(1.0, 0.3));
    CHECK(bool(sky->radiance({0.0 * m, 80.0 * deg, 90.0 * deg, 0.0})));
    CHECK(!sky->radiance({0.0 * m, 80.0 * deg, 91.0 * deg, 0.0}));
    CHECK(bool(sky->radiance({400.0 * km, 109.0 * deg, 60.0 * deg, 180.0 * deg})));
    CHECK(!sky->radiance({400.0 * km, 109.0 * deg, 85.0 * deg, 180.0 * deg}));  // that air is 17 degrees further from the sun
    CHECK(!sky->aerial_perspective({0.0 * m, 80.0 * deg, 91.0 * deg, 0.0}, 1.0 * km));
}

TEST_CASE("nishita1996 of one order is nishita1993, each further order adds light") {
    const auto once = sky_of("nishita1993", earth(1.0, 0.3)), one = sky_of("nishita1996", earth(1.0, 0.3), {.variant = "1"}),
               two = sky_of("nishita1996", earth(1.0, 0.3)), three = sky_of("nishita1996", earth(1.0, 0.3), {.variant = "3"});
    for (const View& view : {View{0.0 * m, 50.0 * deg, 40.0 * deg, 1.0}, View{9.0 * km, 95.0 * deg, 80.0 * deg, 2.0},
                             View{400.0 * km, 150.0 * deg, 60.0 * deg, 0.5}}) {
        CHECK(radiance(*one, view) == doctest::Approx(radiance(*once, view)).epsilon(1e-12));
        const double second = radiance(*two, view) - radiance(*one, view), third = radiance(*three, view) - radiance(*two, view);
        CHECK(second > 0.0);
        CHECK(third > 0.0);
        CHECK(third < 0.6 * second);
    }
}

TEST_CASE("nishita1996 of two orders is the reference's two orders, as near as eight directions come") {
    const Atmosphere air = earth(1.0, 0.3);
    const Result<Reference> reference = Reference::of(air, wavelengths);
    REQUIRE(reference);
    const auto two = sky_of("nishita1996", air), one = sky_of("nishita1996", air, {.variant = "1"});
    double with_two = 0.0, with_one = 0.0;
    for (const double eye : {0.0, 8000.0})
        for (const double sun : {20.0, 75.0})
            for (const double zenith : {0.0, 60.0}) {
                const View view{eye * m, zenith * deg, sun * deg, 60.0 * deg};
                const auto exact = reference->radiance(view, {.paths = 1024, .last_order = 2});
                REQUIRE(exact);
                for (std::size_t w = 0; w < wavelengths.size(); ++w) {
                    const double truth = exact->radiance_W_m2_sr_nm[w];
                    with_two = std::max(with_two, std::abs(radiance(*two, view, w) / truth - 1.0));
                    with_one = std::max(with_one, std::abs(radiance(*one, view, w) / truth - 1.0));
                }
            }
    fmt::print("  nishita1996: within {:.3f} with two orders, {:.3f} with one\n", with_two, with_one);
    // Found: 0.11. The horizon and the low sun, whose light eight directions in one plane cannot hold, are off by up to half.
    CHECK(with_two < 0.15);
    CHECK(with_two < 0.6 * with_one);
}

TEST_CASE("from space the limb is bright and blue, and beyond it there is nothing") {
    for (const char* key : {"kaneda1991", "nishita1993", "dobashi2002", "oneil2004"}) {
        CAPTURE(key);
        const auto sky = sky_of(key, earth());
        // The horizon stands at 109.8 degrees; the air's edge at 107.8.
        CHECK(radiance(*sky, {400.0 * km, 107.0 * deg, 60.0 * deg, 1.0}) == 0.0);
        const View limb{400.0 * km, 109.3 * deg, 60.0 * deg, 1.0};
        CHECK(radiance(*sky, limb, 0) > 1.5 * radiance(*sky, limb, 2));
        CHECK(radiance(*sky, limb) > 0.01);
    }
}

TEST_CASE("Nielsen's average by altitude is nearer to the integral than that by the ends") {
    // Figure 5.2 of the thesis: a point at 1,500 m seen from straight above. Transmittances tell the columns.
    const auto by_altitude = sky_of("nielsen2003", earth()), by_ends = sky_of("nielsen2003", earth(), {.variant = "ends"}),
               exact = sky_of("kaneda1991", earth());
    for (const double eye : {3000.0, 6000.0, 12'000.0}) {
        const auto depth = [&](const Sky& sky) { return -std::log((*sky.transmittance(eye * m, pi, (eye - 1500.0) * m))[1]); };
        CHECK(std::abs(depth(*by_altitude) - depth(*exact)) < std::abs(depth(*by_ends) - depth(*exact)));
    }
}

TEST_CASE("Nielsen's zenith darkens with altitude and his horizon does not") {
    const auto sky = sky_of("nielsen2003", earth());
    const auto zenith = [&](Length eye) { return radiance(*sky, {eye, 0.0, 60.0 * deg, 0.0}); };
    CHECK(zenith(10.0 * km) < 0.5 * zenith(0.0 * m));
    CHECK(zenith(30.0 * km) < 0.2 * zenith(10.0 * km));
    CHECK((*sky->transmittance(20.0 * km, 90.0 * deg, 1e9 * m))[1] ==
          doctest::Approx((*sky->transmittance(0.0 * m, 90.0 * deg, 1e9 * m))[1]));
}

TEST_CASE("Klassen's layer of fog hides what is beyond 200 m and leaves the sky above it") {
    const auto fog = sky_of("klassen1987", earth(), {.variant = "fog"}), clear = sky_of("klassen1987", earth());
    CHECK((*fog->transmittance(0.0 * m, 90.0 * deg, 200.0 * m))[1] == doctest::Approx(0.02).epsilon(0.05));
    const View up{0.0 * m, 0.0, 30.0 * deg, 0.0}, above{1000.0 * m, 0.0, 30.0 * deg, 0.0};
    CHECK((*fog->transmittance(0.0 * m, 0.0, 1e9 * m))[1] ==
          doctest::Approx(std::pow(0.02, 50.0 / 200.0) * (*clear->transmittance(0.0 * m, 0.0, 1e9 * m))[1]).epsilon(1e-6));
    CHECK(radiance(*fog, above) == doctest::Approx(radiance(*clear, above)));
    CHECK(radiance(*fog, up) > radiance(*clear, up));
}

TEST_CASE("a variant that a model has not is named with those that it has") {
    const auto sky = make_sky("nishita1993", earth(), wavelengths, {.variant = "lake"});
    REQUIRE(!sky);
    CHECK(sky.error().message().find("ground, sea") != std::string::npos);
}
