// The parts that tables are baked from: rays, harmonics, maps; and laws that baked tables keep.

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "core/quadrature.h"
#include "transport/altitude_axis.h"
#include "transport/bake.h"
#include "transport/harmonics.h"

using namespace airlight;

namespace {

constexpr Shell earth{6'360'000.0, 100'000.0};

DensityTable earth_densities() {
    const DensityProfile profiles[] = {ExponentialProfile{8.0 * km}, ExponentialProfile{1.2 * km},
                                       TriangleProfile{10.0 * km, 25.0 * km, 40.0 * km}};
    return DensityTable(profiles, 100.0 * km);
}

// The column of an exponential density along a ray, by the midpoint rule with many steps.
double column_by_many_steps(const Ray& ray, double scale_height, double length) {
    constexpr int steps = 400'000;
    double sum = 0.0;
    const double r = earth.bottom_m + ray.altitude_m;
    for (int i = 0; i < steps; ++i) {
        const double t = (i + 0.5) / steps * length;
        const double h = std::sqrt(r * r + t * t + 2.0 * r * ray.mu * t) - earth.bottom_m;
        sum += std::exp(-h / scale_height) * length / steps;
    }
    return sum;
}

Atmosphere small_earth(double scattering_per_m) {
    Atmosphere atmosphere{.name = "one gas",
                          .bottom_radius = 6360.0 * km,
                          .top_altitude = 100.0 * km,
                          .constituents = {},
                          .ground_albedo = SpectrumOf<Number>::constant(0.0),
                          .sun = {}};
    atmosphere.constituents.push_back({"air", ExponentialProfile{8.0 * km}, SpectrumOf<InverseLength>::constant(scattering_per_m * per_m),
                                       SpectrumOf<InverseLength>::constant(0.0 * per_m), RayleighPhase{}});
    return atmosphere;
}

BakeSettings small_bake(int orders) {
    BakeSettings settings{.sizes = {}, .orders = orders, .extrapolate = true};
    settings.sizes.sun = 8;
    settings.sizes.altitude = 6;
    settings.sizes.view = 12;
    settings.sizes.azimuth = 6;
    return settings;
}

}  // namespace

TEST_CASE("spherical harmonics are orthonormal") {
    const HarmonicLayout layout{12};
    const GaussRule rule = gauss_rule(32);
    for (int k = 0; k <= layout.degree; k += 3)
        for (int l = k; l <= layout.degree; ++l)
            for (int other = k; other <= layout.degree; ++other) {
                double sum = 0.0;
                for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
                    const std::vector<float> values = legendre_values(layout, rule.nodes[i]);
                    sum += rule.weights[i] * values[static_cast<std::size_t>(layout.index(l, k))] *
                           values[static_cast<std::size_t>(layout.index(other, k))];
                }
                sum *= k == 0 ? 2.0 * pi : pi;  // the integral of cos^2(k phi)
                CHECK(sum == doctest::Approx(l == other ? 1.0 : 0.0).epsilon(1e-5));
            }
}

TEST_CASE("the columns of a ray are the integrals of the density, from the zenith to the horizon and across the limb") {
    const DensityTable densities = earth_densities();
    struct Case {
        double altitude, mu;
    };
    RayNodes nodes;
    for (const Case c : {Case{0.0, 1.0}, Case{0.0, 0.2}, Case{0.0, 0.0}, Case{2000.0, -0.02}, Case{10'000.0, -0.05}, Case{10'000.0, -0.5},
                         Case{100'000.0, -0.17}, Case{100'000.0, -1.0}}) {
        CAPTURE(c.altitude);
        CAPTURE(c.mu);
        const Ray ray{c.altitude, c.mu, 0.5, 0.5};
        sample_ray(earth, ray, densities, {5e-5f, 0.0f}, 16, nodes);
        const f64::Length h = f64::Length::of(c.altitude), bottom = f64::Length::of(earth.bottom_m), top = f64::Length::of(earth.top_m);
        const double length =
            nodes.meets_ground ? f64::distance_to_ground(h, c.mu, bottom).value : f64::distance_to_top(h, c.mu, bottom, top).value;
        CHECK(nodes.total_column_m[0] == doctest::Approx(column_by_many_steps(ray, 8000.0, length)).epsilon(1e-3));
        CHECK(nodes.total_column_m[1] == doctest::Approx(column_by_many_steps(ray, 1200.0, length)).epsilon(1e-3));
        // The weights of the nodes add up to the length, and columns grow along the ray, but for float's rounding of their sum.
        double sum = 0.0;
        for (int n = 0; n < nodes.count; ++n) {
            sum += nodes.length_m[n];
            if (n > 0) CHECK(nodes.column_m[n][0] >= nodes.column_m[n - 1][0] * (1.0f - 2.0f * std::numeric_limits<float>::epsilon()));
        }
        CHECK(sum == doctest::Approx(length).epsilon(1e-4));
    }
}

// Where a layer of haze ends, nodes that straddle its edge gave rings in the sky, one for each node that crossed it.
TEST_CASE("the column of a layer that ends within the air is exact in every direction") {
    const DensityProfile profiles[] = {LayerProfile{0.0 * km, 2.0 * km}};
    const DensityTable densities(profiles, 100.0 * km);
    RayNodes nodes;
    for (double zenith = 0.0; zenith < 89.0; zenith += 0.37) {
        CAPTURE(zenith);
        const double mu = std::cos(zenith * deg);
        sample_ray(earth, {0.0, mu, 0.5, 0.5}, densities, {5e-5f}, 12, nodes);
        const double expected =
            f64::distance_to_top(f64::Length::of(0.0), mu, f64::Length::of(earth.bottom_m), f64::Length::of(2000.0)).value;
        CHECK(nodes.total_column_m[0] == doctest::Approx(expected).epsilon(1e-5));  // the rest is float's
    }
}

TEST_CASE("table maps: to and back is the identity, at every table size") {
    using f64::Length;
    for (const double radius : {1e5, 6.36e6, 7e7})
        for (const double top : {1e4, 1e5})
            for (const int size : {2, 8, 32, 33, 64, 128, 256}) {
                const Length bottom_m = Length::of(radius), top_m = Length::of(top);
                for (int i = 0; i < size; ++i) {
                    const double x = static_cast<double>(i) / (size - 1);
                    CHECK(f64::altitude_coordinate(f64::altitude_of_coordinate(x, top_m), top_m).value ==
                          doctest::Approx(x).epsilon(1e-12));
                    CHECK(f64::sun_coordinate(f64::sun_of_coordinate(x)).value == doctest::Approx(x).epsilon(1e-12));
                    CHECK(f64::view_coordinate(f64::view_of_coordinate(x)).value == doctest::Approx(x).epsilon(1e-12));
                    CHECK(f64::azimuth_coordinate(f64::azimuth_cosine_of_coordinate(x)).value == doctest::Approx(x).epsilon(1e-12));
                    for (const double h : {0.0, 0.01 * top, 0.5 * top, 0.999 * top}) {
                        const f64::Number mu = f64::transmittance_cosine_of_coordinate(Length::of(h), x, bottom_m, top_m);
                        // Near the zenith the distance is flat in the cosine: a rounding of 1e-16 in mu is 1e-8 in the map.
                        CHECK(f64::transmittance_cosine_coordinate(Length::of(h), mu, bottom_m, top_m).value ==
                              doctest::Approx(x).epsilon(1e-7));
                    }
                }
            }
}

TEST_CASE("the altitudes of texels lead back to them, at every size and with any number of jumps") {
    const std::vector<std::vector<double>> jumps_of_layers = {
        {}, {2000.0}, {1.0}, {99'000.0}, {1500.0, 2000.0, 12'000.0}, {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0}};
    for (const auto& jumps : jumps_of_layers)
        for (const int size : {2, 3, 6, 16, 32, 33, 256}) {
            CAPTURE(jumps.size());
            CAPTURE(size);
            const AltitudeAxis axis(1e5, jumps, size);
            REQUIRE(axis.size() == size);
            CHECK(axis.altitude_m(0) == 0.0);
            CHECK(axis.altitude_m(size - 1) == 1e5);
            for (int i = 0; i < size; ++i) {
                CAPTURE(i);
                // A texel is read at its altitude alone: a jump's lower one just below it, since the jump is the upper one's.
                const Texels around = axis.at(static_cast<float>(axis.inner_altitude_m(i)));
                CHECK(around.low + around.weight == doctest::Approx(i).epsilon(0.01));
                CHECK(around.low >= 0);
                CHECK(around.high < size);
                if (i > 0) CHECK(axis.altitude_m(i) >= axis.altitude_m(i - 1));
            }
        }
}

TEST_CASE("nothing is interpolated across a jump of density, and beyond the top stands the last texel") {
    const double jumps[] = {2000.0, 12'000.0};
    const AltitudeAxis axis(1e5, jumps, 32);
    int pairs = 0;
    for (int i = 1; i < axis.size(); ++i) {
        if (axis.altitude_m(i) != axis.altitude_m(i - 1)) continue;
        CHECK(axis.altitude_m(i) == jumps[pairs++]);
        for (const float h : {0.999f, 1.001f}) {
            const Texels around = axis.at(h * static_cast<float>(axis.altitude_m(i)));
            CHECK((h < 1.0f ? around.high : around.low) == (h < 1.0f ? i - 1 : i));
        }
    }
    CHECK(pairs == 2);
    const Texels above = axis.at(2e5f);
    CHECK(above.high == 31);
    CHECK(above.weight == 1.0f);
}

TEST_CASE("as optical depth goes to zero, the source of higher orders goes to zero with its square") {
    const Wavelength wavelength[] = {550.0 * nm};
    const PackTables thin = *bake_pack(air_optics(small_earth(1e-9), wavelength), small_bake(3), {});
    const PackTables thinner = *bake_pack(air_optics(small_earth(1e-10), wavelength), small_bake(3), {});
    // The source is divided by the scattering coefficient: one power of it is gone.
    const f32::RadianceSpectrum a = thin.source.look_up({0.9f, 0.5f, 0.2f, 0.1f});
    const f32::RadianceSpectrum b = thinner.source.look_up({0.9f, 0.5f, 0.2f, 0.1f});
    CHECK(a.v[0] / b.v[0] == doctest::Approx(10.0).epsilon(1e-3));
}

// The orders beyond those computed are a few hundredths of the light here; the series that stands for them leaves less than
// half a hundredth wrong wherever the sky is brighter than a thousandth of its brightest.
TEST_CASE("orders computed and orders extrapolated agree") {
    const Wavelength wavelength[] = {450.0 * nm};
    const AirOptics optics = air_optics(small_earth(3e-5), wavelength);  // vertical optical depth 0.24
    const PackTables few = *bake_pack(optics, small_bake(BakeSettings{}.orders), {});
    const PackTables many = *bake_pack(optics, small_bake(10), {});
    float brightest = 0.0f;
    for (const f32::RadianceSpectrum& cell : many.source.cells()) brightest = std::max(brightest, cell.v[0]);
    double worst = 0.0;
    for (std::size_t i = 0; i < many.source.cells().size(); ++i) {
        const float exact = many.source.cells()[i].v[0];
        if (exact > 1e-3f * brightest) worst = std::max(worst, std::abs(static_cast<double>(few.source.cells()[i].v[0]) / exact - 1.0));
    }
    CHECK(worst < 5e-3);
}

TEST_CASE("an interrupted bake says so") {
    std::stop_source stop;
    stop.request_stop();
    const Wavelength wavelength[] = {550.0 * nm};
    Progress progress;
    progress.stop = stop.get_token();
    const Result<PackTables> tables = bake_pack(air_optics(small_earth(1e-5), wavelength), small_bake(2), progress);
    REQUIRE(!tables);
    CHECK(tables.error().message().find("interrupted") != std::string::npos);
}

TEST_CASE("a bake that is stopped after its second order and goes on from there ends in the same bits") {
    const Wavelength wavelengths[] = {450.0 * nm, 650.0 * nm};
    const AirOptics optics = air_optics(small_earth(3e-5), wavelengths);
    const BakeSettings settings = small_bake(4);
    const PackTables whole = *bake_pack(optics, settings, {});

    std::stop_source stop;
    Progress progress;
    progress.stop = stop.get_token();
    BakeState kept;
    BakeSteps steps;
    steps.order_done = [&](const BakeState& state) {
        kept = state;
        if (state.orders_done == 2) stop.request_stop();
    };
    REQUIRE(!bake_pack(optics, settings, progress, steps));
    REQUIRE(kept.orders_done == 2);
    int orders_told = 0;
    const PackTables resumed = *bake_pack(optics, settings, {}, {std::move(kept), [&](const BakeState&) { ++orders_told; }});
    CHECK(orders_told == 1);  // the third; the fourth is the last, and its result is returned

    const auto same_bits = [](auto a, auto b) { return std::memcmp(a.data(), b.data(), a.size_bytes()) == 0; };
    CHECK(same_bits(whole.transmittance.cells(), resumed.transmittance.cells()));
    CHECK(same_bits(whole.source.cells(), resumed.source.cells()));
    CHECK(same_bits(whole.irradiance.cells(), resumed.irradiance.cells()));
}
