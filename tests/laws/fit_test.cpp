// Fits: least squares, finished jobs, turbidity, and forms that find themselves again.

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>

#include "atmosphere/presets.h"
#include "core/files.h"
#include "fit/hosek2012.h"
#include "fit/least_squares.h"
#include "models/turbidity.h"
#include "tools/temporary_folder.h"

using namespace airlight;

namespace {

// y = a exp(b x) at eleven points.
LeastSquares exponential(double a, double b) {
    LeastSquares problem;
    problem.residuals = 11;
    problem.evaluate = [=](std::span<const double> p, std::span<double> r) {
        for (std::size_t i = 0; i < r.size(); ++i) {
            const double x = 0.1 * static_cast<double>(i);
            r[i] = p[0] * std::exp(p[1] * x) - a * std::exp(b * x);
        }
    };
    return problem;
}

Job counted_job(int i, int& calls) {
    return {JobKey("test").add(std::vector<double>{static_cast<double>(i)}).hash(),
            [i, &calls](const Progress&) {
                ++calls;
                return Result<std::vector<double>>({i + 0.25, -1.0 / (i + 3)});
            },
            false};
}

std::vector<HosekSample> samples_of(const HosekCurves& curves) {
    std::vector<HosekSample> samples;
    for (const double sun : {0.1, 0.6, 1.1, 1.3, 1.45, 1.52, 1.57})
        for (const FitDirection& d : fit_directions(sun, 8, 8)) {
            const View view{0.0 * m, d.direction.view_zenith, sun, d.direction.relative_azimuth};
            const double mu = std::cos(view.view_zenith), gamma = std::acos(std::clamp(view_sun_cosine(view), -1.0, 1.0));
            samples.push_back({sun, mu, gamma, hosek_radiance(curves, sun, mu, gamma), 1.0});
        }
    return samples;
}

double difference(const HosekCurves& fitted, std::span<const HosekSample> samples) {
    RelativeRms rms;
    for (const HosekSample& s : samples) rms.add(hosek_radiance(fitted, s.sun_zenith, s.mu, s.gamma), s.radiance);
    return rms.value();
}

}  // namespace

TEST_CASE("least squares find the parameters that samples were made of, with and without given derivatives") {
    LeastSquares problem = exponential(2.0, -1.5);
    const LeastSquaresFit plain = least_squares(problem, {1.0, 0.0});
    problem.differentiate = [](std::span<const double> p, std::span<double> d) {
        for (std::size_t i = 0; i < 11; ++i) {
            const double x = 0.1 * static_cast<double>(i);
            d[i] = std::exp(p[1] * x);
            d[11 + i] = p[0] * x * std::exp(p[1] * x);
        }
    };
    const LeastSquaresFit exact = least_squares(problem, {1.0, 0.0});
    for (const LeastSquaresFit* fit : {&plain, &exact}) {
        CHECK(fit->parameters[0] == doctest::Approx(2.0).epsilon(1e-6));
        CHECK(fit->parameters[1] == doctest::Approx(-1.5).epsilon(1e-6));
        CHECK(fit->root_mean_square < 1e-6);
    }
}

TEST_CASE("finished jobs come back to the bit, a damaged one is as one that is not there") {
    const test::TemporaryFolder folder;
    const JobStore store(folder.path / "jobs");
    const TableKey key = JobKey("one").hash(), other = JobKey("other").hash();
    const std::vector<double> numbers = {0.1, -0.0, 1e300, 5e-324};
    CHECK(!store.load(key));
    REQUIRE(store.save(key, numbers));
    const auto loaded = store.load(key);
    REQUIRE(loaded);
    CHECK(std::memcmp(loaded->data(), numbers.data(), sizeof(double) * 4) == 0);

    const auto path = folder.path / "jobs" / (key_text(key) + ".job");
    const std::string whole = *read_file(path);
    for (std::size_t i = 0; i < whole.size(); ++i) {
        std::string damaged = whole;
        damaged[i] = static_cast<char>(damaged[i] ^ 1);
        REQUIRE(write_file(path, damaged));
        CHECK(!store.load(key));
        REQUIRE(write_file(path, std::string_view(whole).substr(0, i)));
        CHECK(!store.load(key));
    }
    // A file under another job's name is not that job.
    REQUIRE(write_file(folder.path / "jobs" / (key_text(other) + ".job"), whole));
    CHECK(!store.load(other));
    CHECK(JobStore("").save(key, numbers));
    CHECK(!JobStore("").load(key));
}

TEST_CASE("a run that is stopped loses the job at work and no other") {
    const test::TemporaryFolder folder;
    const JobStore store(folder.path);
    Team team;
    int calls = 0;
    std::stop_source stop;
    std::vector<Job> jobs;
    for (int i = 0; i < 5; ++i) jobs.push_back(counted_job(i, calls));
    const auto third = jobs[2].compute;
    jobs[2].compute = [&](const Progress&) {
        stop.request_stop();
        return Result<std::vector<double>>(Error{"", "stopped", ""});
    };
    CHECK(!team.computed(jobs, store, "test", Progress{.stop = stop.get_token()}));
    CHECK(calls == 2);
    jobs[2].compute = third;
    const auto all = team.computed(jobs, store, "test", {});
    REQUIRE(all);
    CHECK(calls == 5);
    for (int i = 0; i < 5; ++i) CHECK((*all)[static_cast<std::size_t>(i)] == std::vector<double>{i + 0.25, -1.0 / (i + 3)});
    // On all cores as well, and nothing is done twice.
    for (Job& job : jobs) job.one_core = true;
    CHECK(*team.computed(jobs, store, "test", {}) == *all);
    CHECK(calls == 5);
}

TEST_CASE("air takes any turbidity by its aerosol alone") {
    const Atmosphere clear = *preset("earth-clear");
    for (const double t : {1.0, 2.5, 10.0}) {
        const Result<Atmosphere> air = with_turbidity(clear, t);
        REQUIRE(air);
        CHECK(*turbidity(*air) == doctest::Approx(t).epsilon(1e-12));
        for (std::size_t i = 0; i < clear.constituents.size(); ++i) {
            const Constituent &before = clear.constituents[i], &after = air->constituents[i];
            const bool aerosol = !std::holds_alternative<RayleighPhase>(before.phase) && before.scattering.at(550.0 * nm) > 0.0 * per_m;
            CHECK(before.profile == after.profile);
            if (!aerosol) CHECK(before == after);
        }
    }
    CHECK(with_turbidity(clear, 0.9).error().what == "a turbidity of 0.9 is out of range: it must be 1 or more");
    CHECK(with_turbidity(*preset("earth-rayleigh"), 2.0).error().where == "earth-rayleigh");
}

TEST_CASE("directions of a fit lie above the horizon, and stand for equal solid angles") {
    for (const double sun : {0.0, 0.7, 1.5707963}) {
        double sum = 0.0, weight = 0.0;
        for (const FitDirection& d : fit_directions(sun, 12, 12)) {
            CHECK(d.direction.view_zenith < 0.5 * pi);
            if (d.weight != 1.0) continue;
            sum += std::cos(d.direction.view_zenith);
            weight += 1.0;
        }
        CHECK(sum / weight == doctest::Approx(0.5));  // the mean cosine over a hemisphere
    }
}

TEST_CASE("the weights of a Bezier curve are a partition of one, and its ends are its points") {
    for (const double sun : {0.0, 0.3, 1.0, 1.5, 0.5 * pi}) {
        double sum = 0.0;
        for (const double w : bezier_weights(sun)) {
            CHECK(w >= 0.0);
            sum += w;
        }
        CHECK(sum == doctest::Approx(1.0));
    }
    CHECK(bezier_weights(0.0)[5] == doctest::Approx(1.0));
    CHECK(bezier_weights(0.5 * pi)[0] == doctest::Approx(1.0));
}

TEST_CASE("hosek2012's form finds a sky of its own again, and stays where it is already right") {
    // Near what clear skies have; each curve with another slope.
    HosekCurves curves;
    const double at_horizon[10] = {-1.1, -0.4, 0.5, 2.0, -3.0, 0.3, 0.1, 0.5, 0.5, 0.02};
    const double at_zenith[10] = {-1.0, -0.2, 0.8, 1.0, -2.5, 0.5, 0.05, 0.3, 0.6, 0.10};
    for (std::size_t k = 0; k < 10; ++k)
        for (std::size_t p = 0; p < bezier_points; ++p)
            curves[k][p] = at_horizon[k] + (at_zenith[k] - at_horizon[k]) * static_cast<double>(p) / 5.0;
    const std::vector<HosekSample> samples = samples_of(curves);
    // The spring that holds flat directions leaves less than this.
    CHECK(difference(fitted_hosek(samples, nullptr), samples) < 1e-2);
    CHECK(difference(fitted_hosek(samples, &curves), samples) < 1e-6);
}

TEST_CASE("a fitted sky is used by its file, and is as near the truth as the fit says") {
    const test::TemporaryFolder folder;
    Team team;
    HosekFitSettings settings;
    settings.turbidities = {2.0, 3.0};
    settings.albedos = {0.2};
    settings.wavelengths = {450.0 * nm, 650.0 * nm};
    settings.truth.bake = {
        .sizes = {.transmittance_mu = 64, .transmittance_altitude = 32, .sun = 16, .azimuth = 4, .view = 12, .altitude = 10}, .orders = 3};
    const Atmosphere clear = *preset("earth-clear");
    const Result<HosekFit> fit = fit_hosek2012(clear, settings, team, JobStore(""), {});
    REQUIRE(fit);
    for (const ResidualLine& line : fit->residuals) {
        CAPTURE(line.condition);
        CHECK(line.relative_rms < 0.1);
    }
    const auto file = folder.path / "fit.csv";
    REQUIRE(write_file(file, hosek_csv(*fit, clear.name)));
    // Between the turbidities, suns and directions of the fit.
    Atmosphere air = *with_turbidity(clear, 2.5);
    air.ground_albedo = SpectrumOf<Number>::constant(0.2);
    ModelOptions options;
    options.data = file;
    options.bake = settings.truth.bake;
    options.cache.enabled = false;
    const auto model = make_sky("hosek2012", air, settings.wavelengths, options),
               truth = make_sky("tables", air, settings.wavelengths, options);
    REQUIRE(model);
    REQUIRE(truth);
    RelativeRms rms;
    for (const double elevation_deg : {7.0, 20.0, 40.0, 65.0})
        for (const FitDirection& d : fit_directions((90.0 - elevation_deg) * deg, 7, 7)) {
            if (d.weight < 1.0) continue;
            const View view{0.0 * m, d.direction.view_zenith, (90.0 - elevation_deg) * deg, d.direction.relative_azimuth};
            const auto seen = (*model)->radiance(view), there = (*truth)->radiance(view);
            for (std::size_t w = 0; w < 2; ++w) rms.add(seen->radiance_W_m2_sr_nm[w], there->radiance_W_m2_sr_nm[w]);
        }
    CHECK(rms.value() < 0.1);
}
