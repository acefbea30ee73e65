// The sky from tables keeps its laws, and agrees with the reference where both answer.

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "core/quadrature.h"
#include "sky/reference_sky.h"
#include "sky/table_sky.h"

using namespace airlight;

namespace {

SpectrumOf<InverseLength> rayleigh_like(double at_550) {
    std::vector<SpectrumOf<InverseLength>::Sample> samples;
    for (const double w : {360.0, 450.0, 550.0, 650.0, 830.0}) samples.push_back({w * nm, at_550 * std::pow(550.0 / w, 4.0) * per_m});
    return *SpectrumOf<InverseLength>::of(samples);
}

Atmosphere hazy_earth() {
    const auto constant = [](double x) { return SpectrumOf<InverseLength>::constant(x * per_m); };
    Atmosphere atmosphere{.name = "hazy",
                          .bottom_radius = 6360.0 * km,
                          .top_altitude = 100.0 * km,
                          .constituents = {},
                          .ground_albedo = SpectrumOf<Number>::constant(0.2),
                          .sun = {}};
    atmosphere.constituents = {
        {"air", ExponentialProfile{8.0 * km}, rayleigh_like(1.2e-5), constant(0.0), RayleighPhase{}},
        {"haze", ExponentialProfile{1.2 * km}, constant(1.5e-4), constant(1.5e-5),
         HenyeyGreensteinPhase{SpectrumOf<Number>::constant(0.76)}},
        {"ozone", TriangleProfile{10.0 * km, 25.0 * km, 40.0 * km}, constant(0.0), constant(1.8e-6), IsotropicPhase{}},
    };
    atmosphere.sun.angular_radius = 0.2666 * deg;
    return atmosphere;
}

const std::vector<Wavelength> wavelengths = {450.0 * nm, 550.0 * nm, 650.0 * nm};

const TableSky& hazy_sky() {
    static const TableSky sky = [] {
        BakeSettings settings;
        settings.sizes = {.transmittance_mu = 128, .transmittance_altitude = 64, .sun = 24, .azimuth = 10, .view = 20, .altitude = 10};
        settings.orders = 4;
        return TableSky(std::make_shared<Tables>(*bake_tables(hazy_earth(), wavelengths, settings, {})));
    }();
    return sky;
}

}  // namespace

TEST_CASE("what the sky sends down, summed over its directions, is the diffuse irradiance") {
    for (const double sun : {20.0, 70.0, 92.0})
        for (const double altitude : {0.0, 5000.0}) {
            CAPTURE(sun);
            CAPTURE(altitude);
            // Polar coordinates around the zenith; the aureole of this haze is wide enough for them.
            const GaussRule zeniths = gauss_rule(160, 0.0, 0.5 * pi);
            const GaussRule azimuths = gauss_rule(80, 0.0, pi);
            std::vector<double> sum(wavelengths.size(), 0.0);
            for (std::size_t i = 0; i < zeniths.nodes.size(); i += 1)
                for (std::size_t j = 0; j < azimuths.nodes.size(); ++j) {
                    const double z = zeniths.nodes[i];
                    const auto seen = hazy_sky().radiance({altitude * m, z, sun * deg, azimuths.nodes[j]});
                    for (std::size_t w = 0; w < sum.size(); ++w)
                        sum[w] += seen->radiance_W_m2_sr_nm[w] * std::cos(z) * std::sin(z) * zeniths.weights[i] * azimuths.weights[j] * 2.0;
                }
            const auto irradiance = hazy_sky().irradiance(altitude * m, sun * deg);
            // The table has 24 suns and 10 altitudes here: its interpolation is what the bound allows for.
            for (std::size_t w = 0; w < sum.size(); ++w)
                CHECK(sum[w] == doctest::Approx(irradiance->diffuse_W_m2_nm[w]).epsilon(sun > 90.0 ? 0.15 : 0.03));
        }
}

TEST_CASE("a dome's radiance is that of single questions") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<float> from_dome(wavelengths.size());
    for (const double altitude : {0.0, 2000.0, 30'000.0, 400'000.0})
        for (const double sun : {30.0, 80.0, 94.0}) {
            const auto dome = *hazy_sky().dome(altitude * m, sun * deg);
            double worst = 0.0;
            for (int i = 0; i < 300; ++i) {
                const double z = unit(random) * pi, azimuth = unit(random) * 2.0 * pi;
                const auto exact = hazy_sky().radiance({altitude * m, z, sun * deg, azimuth});
                dome->radiance(z, azimuth, from_dome);
                // Relative to the direction's own radiance, but for the darkest.
                for (std::size_t w = 0; w < wavelengths.size(); ++w)
                    worst =
                        std::max(worst, std::abs(from_dome[w] - exact->radiance_W_m2_sr_nm[w]) / (exact->radiance_W_m2_sr_nm[w] + 1e-6));
            }
            CAPTURE(altitude);
            CAPTURE(sun);
            CHECK(worst < 0.02);
        }
}

TEST_CASE("no query of the sky is negative, infinite or not a number") {
    std::mt19937 random(20260102);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int i = 0; i < 20'000; ++i) {
        const View view{std::pow(10.0, -2.0 + 10.0 * unit(random)) * m, std::acos(2.0 * unit(random) - 1.0), pi * unit(random),
                        2.0 * pi * unit(random)};
        const auto seen = hazy_sky().radiance(view);
        REQUIRE(seen);
        for (const double radiance : seen->radiance_W_m2_sr_nm) {
            CHECK(std::isfinite(radiance));
            CHECK(radiance >= 0.0);
        }
    }
}

TEST_CASE("Beer and Lambert: transmittance over two legs is the product of the legs") {
    const double z = 100.0 * deg;
    const Length first = 60.0 * km, second = 45.0 * km;
    const double r = 6360e3 + 12e3;
    const double r_mid = std::sqrt(r * r + first.value * first.value + 2.0 * r * first.value * std::cos(z));
    const double z_mid = std::acos((r * std::cos(z) + first.value) / r_mid);
    const auto whole = *hazy_sky().transmittance(12.0 * km, z, first + second);
    const auto a = *hazy_sky().transmittance(12.0 * km, z, first);
    const auto b = *hazy_sky().transmittance((r_mid - 6360e3) * m, z_mid, second);
    for (std::size_t w = 0; w < whole.size(); ++w) CHECK(whole[w] == doctest::Approx(a[w] * b[w]).epsilon(1e-4));
}

TEST_CASE("the sky of tables has the transmittance of the reference") {
    const ReferenceSky truth(*Reference::of(hazy_earth(), wavelengths), hazy_earth().bottom_radius, {});
    for (const double altitude : {0.0, 3000.0, 50'000.0, 400'000.0})
        for (const double z : {0.0, 60.0, 89.0, 91.0, 100.0, 109.0, 130.0, 180.0})
            for (const double distance : {1e3, 3e4, 1e7}) {
                CAPTURE(altitude);
                CAPTURE(z);
                CAPTURE(distance);
                const auto expected = truth.transmittance(altitude * m, z * deg, distance * m);
                const auto found = hazy_sky().transmittance(altitude * m, z * deg, distance * m);
                REQUIRE(expected);
                for (std::size_t w = 0; w < wavelengths.size(); ++w) CHECK(std::abs((*found)[w] - (*expected)[w]) < 1e-3);
            }
}

TEST_CASE("the sun's disk, summed over its solid angle, gives the irradiance above the air") {
    Sun sun;
    sun.irradiance = SpectrumOf<SpectralIrradiance>::constant(1.7 * W_per_m2_nm);
    sun.angular_radius = 0.0046;
    sun.limb_darkening_1 = SpectrumOf<Number>::constant(0.5);
    sun.limb_darkening_2 = SpectrumOf<Number>::constant(0.2);
    const GaussRule rule = gauss_rule(200, 0.0, sun.angular_radius);
    double sum = 0.0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i)
        sum += sun_disk_radiance(sun, wavelengths, rule.nodes[i])[0] * 2.0 * pi * std::sin(rule.nodes[i]) * rule.weights[i];
    CHECK(sum == doctest::Approx(1.7).epsilon(1e-5));
    CHECK(sun_disk_radiance(sun, wavelengths, 0.0047)[0] == 0.0);
}

TEST_CASE("an eye below the ground and a sun beyond the nadir are refused") {
    CHECK(hazy_sky().radiance({-1.0 * m, 0.0, 0.0, 0.0}).error().message().find("below the ground") != std::string::npos);
    CHECK(hazy_sky().radiance({0.0 * m, 0.0, 181.0 * deg, 0.0}).error().message().find("0 to 180 deg") != std::string::npos);
    CHECK(!hazy_sky().dome(-1.0 * m, 0.0));
    CHECK(!hazy_sky().irradiance(0.0 * m, std::nan("")));
}
