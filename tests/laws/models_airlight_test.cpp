// The model `airlight` beside the sky from tables that it is packed from, and by itself.

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "atmosphere/presets.h"
#include "models/airlight_row.h"
#include "models/model.h"
#include "sky/table_sky.h"
#include "tools/temporary_folder.h"

using namespace airlight;

namespace {

const std::vector<Wavelength> wavelengths = {400.0 * nm, 550.0 * nm, 700.0 * nm};

// A bake of a second: the same tables for both skies.
BakeSettings quick_bake() {
    return {.sizes = {.transmittance_mu = 128, .transmittance_altitude = 64, .sun = 40, .azimuth = 6, .view = 12, .altitude = 16},
            .orders = 2};
}

struct Skies {
    Skies() {
        const test::TemporaryFolder folder;
        ModelOptions options;
        options.bake = quick_bake();
        options.cache.folder = folder.path;
        tables = *make_sky("tables", *preset("earth-clear"), wavelengths, options);
        packed = *make_sky("airlight", *preset("earth-clear"), wavelengths, options);
    }
    std::unique_ptr<Sky> tables, packed;
};
const Skies& skies() {
    static const Skies both;
    return both;
}

}  // namespace

TEST_CASE("airlight: the tables of sixteen wavelengths take at most 4 MiB") {
    const Tables tables = *bake_tables(*preset("earth-clear"), wavelengths, quick_bake(), {});
    CHECK(airlight_tables(tables.packs()[0], 12).bytes() <= 4 * 1024 * 1024);
}

// By day the tables' own interpolation is good to a percent or two, and packing keeps it.
TEST_CASE("airlight: by day it is the sky from tables that it is packed from") {
    for (const double altitude_m : {0.0, 10'000.0, 400'000.0})
        for (const double zenith : {10.0, 60.0, 88.0, 105.0, 109.0, 150.0})
            for (const double sun : {20.0, 70.0}) {
                const View view{altitude_m * m, zenith * deg, sun * deg, 100.0 * deg};
                const auto a = skies().tables->radiance(view)->radiance_W_m2_sr_nm, b = skies().packed->radiance(view)->radiance_W_m2_sr_nm;
                CAPTURE(altitude_m);
                CAPTURE(zenith);
                CAPTURE(sun);
                for (std::size_t w = 0; w < a.size(); ++w) CHECK(b[w] == doctest::Approx(a[w]).epsilon(0.02));
            }
}

TEST_CASE("airlight: transmittance over two legs is the product of the legs") {
    const Sky& sky = *skies().packed;
    const auto whole = *sky.transmittance(2000.0 * m, 60.0 * deg, 20.0 * km);
    const auto first = *sky.transmittance(2000.0 * m, 60.0 * deg, 8.0 * km);
    // Where the first leg ends, by the triangle of the planet's centre.
    const double bottom = preset("earth-clear")->bottom_radius.value, r = bottom + 2000.0, t = 8000.0,
                 end = std::sqrt(r * r + t * t + 2.0 * r * t * std::cos(60.0 * deg));
    const double zenith = std::acos((r * std::cos(60.0 * deg) + t) / end);
    const auto second = *sky.transmittance((end - bottom) * m, zenith, 12.0 * km);
    for (std::size_t w = 0; w < whole.size(); ++w) CHECK(first[w] * second[w] == doctest::Approx(whole[w]).epsilon(2e-4));
}

TEST_CASE("airlight: the air of a whole view of the sky is the sky, and that of no distance is nothing") {
    const View view{0.0 * m, 75.0 * deg, 50.0 * deg, 30.0 * deg};
    const auto sky = skies().packed->radiance(view)->radiance_W_m2_sr_nm;
    const AerialPerspective whole = *skies().packed->aerial_perspective(view, 1e9 * m),
                            none = *skies().packed->aerial_perspective(view, 0.0 * m);
    for (std::size_t w = 0; w < sky.size(); ++w) {
        CHECK(whole.inscattered_W_m2_sr_nm[w] == doctest::Approx(sky[w]).epsilon(1e-5));
        CHECK(none.inscattered_W_m2_sr_nm[w] == 0.0);
        CHECK(none.transmittance[w] == 1.0);
    }
}

TEST_CASE("airlight: no query is answered by a negative, an infinity or no number") {
    std::mt19937 random(20261124);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const double bottom = preset("earth-clear")->bottom_radius.value;
    for (int i = 0; i < 5000; ++i) {
        const double altitude = uniform(random) < 0.3 ? 0.0 : std::pow(10.0, 8.0 * uniform(random));
        const double horizon = pi - std::asin(bottom / (bottom + altitude));
        const double zenith =
            uniform(random) < 0.5 ? std::acos(2.0 * uniform(random) - 1.0) : horizon + (uniform(random) - 0.5) * 2.0 * deg;
        const View view{altitude * m, std::min(zenith, pi), pi * uniform(random), 2.0 * pi * uniform(random)};
        CAPTURE(altitude);
        CAPTURE(zenith);
        CAPTURE(view.sun_zenith);
        const std::vector<double> seen = skies().packed->radiance(view)->radiance_W_m2_sr_nm;
        for (const double x : seen) CHECK((x >= 0.0 && x < 100.0));
    }
}

// The dome is cubic between rays of fewer nodes.
TEST_CASE("airlight: a dome is its rays") {
    for (const double altitude_m : {2.0, 2000.0, 10'000.0, 400'000.0}) {
        const auto dome = *skies().packed->dome(altitude_m * m, 60.0 * deg);
        const double horizon = pi - std::asin(6371e3 / (6371e3 + altitude_m));
        for (const double zenith : {5.0 * deg, 45.0 * deg, 80.0 * deg, 89.0 * deg, horizon - 0.5 * deg, horizon - 0.02 * deg,
                                    horizon + 0.02 * deg, horizon + 0.5 * deg, 140.0 * deg, 179.0 * deg})
            for (const double azimuth : {0.0, 33.0, 170.0}) {
                const auto ray = skies().packed->radiance({altitude_m * m, zenith, 60.0 * deg, azimuth * deg})->radiance_W_m2_sr_nm;
                std::vector<float> seen(ray.size());
                dome->radiance(zenith, azimuth * deg, seen);
                CAPTURE(altitude_m);
                CAPTURE(zenith / deg);
                CAPTURE(azimuth);
                for (std::size_t w = 0; w < ray.size(); ++w) CHECK(seen[w] == doctest::Approx(ray[w]).epsilon(0.01));
            }
    }
}

TEST_CASE("airlight: directions of one zenith angle, asked together, are those asked alone") {
    const auto dome = *skies().packed->dome(2.0 * m, 60.0 * deg);
    std::vector<Direction> directions;
    for (const double zenith : {20.0, 89.5, 120.0})
        for (int i = 0; i < 20; ++i) directions.push_back({zenith * deg, 0.31 * i - 1.0});
    const std::size_t count = wavelengths.size();
    std::vector<float> together(directions.size() * count), alone(count);
    dome->radiances(directions, together);
    for (std::size_t i = 0; i < directions.size(); ++i) {
        dome->radiance(directions[i].view_zenith, directions[i].relative_azimuth, alone);
        for (std::size_t w = 0; w < count; ++w) CHECK(together[i * count + w] == doctest::Approx(alone[w]).epsilon(1e-5));
    }
}

// Rows share their way through the air but where the planet's shadow cuts it: by day, in twilight, from space.
TEST_CASE("airlight: a row of rays is its rays") {
    const Tables baked = *bake_tables(*preset("earth-clear"), wavelengths, quick_bake(), {});
    // Pieces are cut at other places: with so many nodes that does not matter.
    const AirlightTables tables = airlight_tables(baked.packs()[0], f32::airlight_nodes);
    for (const double h : {0.0, 2000.0, 100'000.0})
        for (const double mu : {0.8, 0.02, -0.02, -0.1, -0.9})
            for (const double mu_s : {0.7, -0.05, -0.15}) {
                std::vector<f32::AirlightRay> rays;
                for (int i = 0; i < 9; ++i)
                    rays.push_back({f32::Length::of(static_cast<float>(h)), f32::Number(mu), f32::Number(mu_s),
                                    f32::Number(mu * mu_s + std::sqrt((1 - mu * mu) * (1 - mu_s * mu_s)) * std::cos(pi * i / 8)),
                                    f32::Length::of(1e30f)});
                const std::vector<f32::AirlightLight> row = airlight_row(tables.air, tables, rays);
                for (std::size_t i = 0; i < rays.size(); ++i) {
                    const f32::AirlightLight alone = tables.light(rays[i]);
                    CAPTURE(h);
                    CAPTURE(mu);
                    CAPTURE(mu_s);
                    CAPTURE(i);
                    for (int w = 0; w < 3; ++w) {
                        CHECK(row[i].transmittance.v[w] == doctest::Approx(alone.transmittance.v[w]).epsilon(1e-3));
                        CHECK(row[i].multiple.v[w] == doctest::Approx(alone.multiple.v[w]).epsilon(0.01));
                        CHECK(row[i].single[0].v[w] == doctest::Approx(alone.single[0].v[w]).epsilon(0.01));
                    }
                }
            }
}
