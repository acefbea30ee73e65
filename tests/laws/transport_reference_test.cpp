// The Monte Carlo reference: its columns, its samplers, and the laws that its light must keep.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <random>

#include "core/parallel.h"
#include "core/quadrature.h"
#include "transport/columns.h"
#include "transport/reference.h"
#include "transport/reference_path.h"

using namespace airlight;

namespace {

SpectrumOf<InverseLength> constant(double coefficient) { return SpectrumOf<InverseLength>::constant(coefficient * per_m); }

Constituent constituent(const char* name, DensityProfile profile, double scattering, double absorption, PhaseFunction phase) {
    return {name, std::move(profile), constant(scattering), constant(absorption), std::move(phase)};
}

// Air and aerosol of vertical optical depths near 0.1 and 0.06, with ozone.
Atmosphere earth(double radius_m = 6.36e6) {
    Atmosphere a;
    a.name = "Earth";
    a.bottom_radius = radius_m * m;
    a.top_altitude = 100.0 * km;
    a.constituents = {
        constituent("air", ExponentialProfile{8.0 * km}, 1.2e-5, 0.0, RayleighPhase{}),
        constituent("aerosol", ExponentialProfile{1.2 * km}, 4.5e-5, 5e-6, HenyeyGreensteinPhase{SpectrumOf<Number>::constant(0.76)}),
        constituent("ozone", TriangleProfile{10.0 * km, 25.0 * km, 40.0 * km}, 0.0, 2e-6, IsotropicPhase{})};
    a.ground_albedo = SpectrumOf<Number>::constant(0.1);
    return a;
}

const std::vector<Wavelength> one_wavelength = {550.0 * nm};

// The column of one density along a leg, adaptively; double precision in altitude, so that no digits are lost on large planets.
double exact_column(const DensityProfile& profile, double bottom, double h, double mu, double to) {
    static const GaussRule rule = gauss_rule(20, 0.0, 1.0);
    const auto integral = [&](double a, double b) {
        double sum = 0.0;
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            const double t = a + (b - a) * rule.nodes[i];
            const double gain = t * (2.0 * (bottom + h) * mu + t);
            const double r = bottom + h;
            sum += rule.weights[i] * relative_density(profile, Length::of(h + gain / (std::sqrt(r * r + gain) + r)));
        }
        return (b - a) * sum;
    };
    const std::function<double(double, double, double, int)> refined = [&](double a, double b, double whole, int depth) -> double {
        const double c = 0.5 * (a + b);
        const double left = integral(a, c), right = integral(c, b);
        if (depth >= 25 || std::abs(left + right - whole) <= 1e-10 * (left + right) + 1e-9) return left + right;
        return refined(a, c, left, depth + 1) + refined(c, b, right, depth + 1);
    };
    // Pieces end where the ray crosses a kink: a rule between two kinks cannot be fooled.
    std::vector<double> ends;
    for (int i = 0; i <= 16; ++i) ends.push_back(to * i / 16.0);
    const double q = (bottom + h) * mu;
    for (const Length kink : kinks(profile)) {
        const double root = q * q + (kink.value - h) * (2.0 * bottom + kink.value + h);
        if (root < 0.0) continue;
        for (const double t : {-q - std::sqrt(root), -q + std::sqrt(root)})
            if (t > 0.0 && t < to) ends.push_back(t);
    }
    std::sort(ends.begin(), ends.end());
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) sum += refined(ends[i], ends[i + 1], integral(ends[i], ends[i + 1]), 0);
    return sum;
}

struct Planet {
    std::string name;
    double bottom, top;
    std::vector<DensityProfile> profiles;
};

std::vector<Planet> planets() {
    std::vector<Curve<Length, Number>::Sample> samples;
    for (int i = 0; i <= 40; ++i) samples.push_back({i * 1.5 * km, std::exp(-i * 1.5 / (7.0 + 2.0 * std::sin(i)))});
    const DensityProfile tabulated = TabulatedProfile{*Curve<Length, Number>::of(samples)};
    return {{"Earth",
             6.36e6,
             1e5,
             {ExponentialProfile{8.0 * km}, ExponentialProfile{1.2 * km}, TriangleProfile{10.0 * km, 25.0 * km, 40.0 * km}}},
            {"flat", 1e11, 1e5, {ExponentialProfile{8.0 * km}, ExponentialProfile{1.2 * km}, LayerProfile{0.0 * km, 100.0 * km}}},
            {"layers", 6.36e6, 1e5, {LayerProfile{5.0 * km, 6.0 * km}, tabulated, ExponentialProfile{50.0 * m, 2.0 * km}}},
            {"small", 1e5, 5e4, {ExponentialProfile{8.0 * km}, LayerProfile{1.0 * km, 30.0 * km}}},
            {"large", 7e7, 1e6, {ExponentialProfile{27.0 * km}, TriangleProfile{100.0 * km, 300.0 * km, 301.0 * km}}}};
}

}  // namespace

TEST_CASE("columns give transmittances that agree with adaptive quadrature, on planets of any radius") {
    for (const Planet& planet : planets()) {
        CAPTURE(planet.name);
        const Columns columns(planet.profiles, f64::Length::of(planet.bottom), f64::Length::of(planet.top));
        std::mt19937_64 random(1);
        std::uniform_real_distribution<double> uniform(0.0, 1.0);
        double worst = 0.0;
        for (int i = 0; i < 1500; ++i) {
            const double h = planet.top * std::pow(uniform(random), i % 2 ? 1.0 : 4.0);
            // Half of the rays run close to the horizon of their own altitude.
            const double mu =
                i % 3 == 0 ? std::cos(pi * uniform(random)) : std::copysign(std::pow(uniform(random), 6.0), uniform(random) - 0.5);
            const Columns::Ray ray = columns.ray(h, mu);
            const double t = ray.length * uniform(random);
            const Columns::Stop stop = columns.at_distance(ray, t);
            for (std::size_t c = 0; c < planet.profiles.size(); ++c) {
                // A relative error of a column moves exp(-depth) most where the depth is 1. What is subtracted may be larger
                // than the leg, so the depth is that of the whole ray; it is no larger than air of depth 1000 would give.
                const double exact = exact_column(planet.profiles[c], planet.bottom, h, mu, t);
                const double whole = std::max({exact, ray.start.v[c], ray.low.v[c]});
                if (whole <= 0.0) continue;
                const double extinction = std::min(1.0 / whole, 1000.0 / column_depth(planet.profiles[c], planet.top * m).value);
                const double error = std::abs(std::exp(-exact * extinction) - std::exp(-stop.column.v[c] * extinction));
                if (error > worst) worst = error;
                if (error > 1e-5) {
                    CAPTURE(h);
                    CAPTURE(mu);
                    CAPTURE(t / ray.length);
                    CAPTURE(c);
                    CHECK(error <= 1e-5);
                }
            }
        }
        fmt::print("  {}: largest error of a transmittance {:.1e}\n", planet.name, worst);
    }
}

TEST_CASE("a stop at a depth lies where that depth is reached") {
    for (const Planet& planet : planets()) {
        CAPTURE(planet.name);
        const Columns columns(planet.profiles, f64::Length::of(planet.bottom), f64::Length::of(planet.top));
        std::mt19937_64 random(2);
        std::uniform_real_distribution<double> uniform(0.0, 1.0);
        double worst = 0.0;
        for (int i = 0; i < 3000; ++i) {
            ColumnSet a;
            for (std::size_t c = 0; c < planet.profiles.size(); ++c) a.v[c] = uniform(random) * 1e-4;
            const Columns::Ray ray = columns.ray(planet.top * uniform(random) * uniform(random), std::cos(pi * uniform(random)));
            const double whole = columns.sum(a, ray.total);
            const double depth = whole * uniform(random);
            const Columns::Stop stop = columns.at_depth(ray, a, depth);
            // The last step of the search is below 2e-5 of the column, and Newton's method squares it;
            // differences of columns leave 1e-7 of the larger.
            const double scale = std::max({whole, columns.sum(a, ray.start), columns.sum(a, ray.low), 1e-12});
            worst = std::max({worst, std::abs(columns.sum(a, stop.column) - depth) / scale,
                              std::abs(columns.sum(a, columns.at_distance(ray, stop.t).column) - depth) / scale});
        }
        CHECK(worst < 1e-6);
    }
}

TEST_CASE("drawn scattering angles follow the phase function (chi-square over equal shares)") {
    std::array<Wavelength, pack_size> wavelengths;
    for (std::size_t i = 0; i < pack_size; ++i) wavelengths[i] = (400.0 + 20.0 * static_cast<double>(i)) * nm;
    const auto g = *SpectrumOf<Number>::of({{400.0 * nm, 0.5}, {700.0 * nm, 0.9}});
    for (const PhaseFunction& law :
         std::vector<PhaseFunction>{IsotropicPhase{}, RayleighPhase{}, HenyeyGreensteinPhase{g}, CornetteShanksPhase{g}}) {
        const SpectralPhase phase(law, wavelengths);
        const DirectionSampler sampler(phase);
        for (const int lane : {0, 15}) {
            constexpr int cells = 40, draws = 40000;
            std::vector<double> expected(cells), seen(cells);
            const GaussRule rule = gauss_rule(64);
            for (int k = 0; k < cells; ++k) {
                // Cells are even in the root of the angle.
                const double high = std::cos(pi * std::pow(k / double(cells), 2)),
                             low = std::cos(pi * std::pow((k + 1) / double(cells), 2));
                for (std::size_t i = 0; i < rule.nodes.size(); ++i)
                    expected[static_cast<std::size_t>(k)] += draws * 2.0 * pi * 0.5 * (high - low) * rule.weights[i] *
                                                             phase.at(low + 0.5 * (high - low) * (1.0 + rule.nodes[i])).v[lane];
            }
            Random random(5, static_cast<std::uint64_t>(lane));
            for (int i = 0; i < draws; ++i) {
                const DirectionSampler::Draw draw = sampler.draw(lane, random(), random());
                seen[std::min<std::size_t>(cells - 1, static_cast<std::size_t>(std::sqrt(std::acos(draw.nu) / pi) * cells))] += 1.0;
            }
            double chi_square = 0.0;
            int used = 0;
            for (std::size_t k = 0; k < cells; ++k)
                if (expected[k] > 5.0) {
                    chi_square += std::pow(seen[k] - expected[k], 2) / expected[k];
                    ++used;
                }
            // Mean used - 1, standard deviation sqrt(2 used): beyond five of these once in a million.
            CHECK(chi_square < used + 5.0 * std::sqrt(2.0 * used));
        }
    }
}

TEST_CASE("Beer-Lambert: the transmittance over two legs is the product of the legs") {
    const Reference reference = *Reference::of(earth(), one_wavelength);
    for (const double zenith : {0.3, 1.5, 1.57, 1.6, 2.5})
        for (const double altitude : {0.0, 3e3, 5e4}) {
            const double whole = reference.transmittance(altitude * m, zenith, 2e5 * m)[0];
            const double r = 6.36e6 + altitude, t = 0.4e5;
            const double r_t = std::sqrt(r * r + 2.0 * r * std::cos(zenith) * t + t * t);
            if (r_t <= 6.36e6 || r_t >= 6.46e6 || (altitude == 0.0 && zenith > 1.57)) continue;
            const double first = reference.transmittance(altitude * m, zenith, t * m)[0];
            const double second =
                reference.transmittance((r_t - 6.36e6) * m, std::acos((r * std::cos(zenith) + t) / r_t), (2e5 - t) * m)[0];
            // Each is exact to 1e-6 or so.
            CHECK(first * second == doctest::Approx(whole).epsilon(1e-5));
        }
}

TEST_CASE("Helmholtz: reversing a leg leaves its transmittance unchanged") {
    const Reference reference = *Reference::of(earth(), one_wavelength);
    const double r = 6.36e6 + 2e3, t = 3e4;
    for (const double mu : {-0.02, 0.0, 0.3, 0.9}) {
        const double r_t = std::sqrt(r * r + 2.0 * r * mu * t + t * t);
        CHECK(reference.transmittance(2.0 * km, std::acos(mu), t * m)[0] ==
              doctest::Approx(reference.transmittance((r_t - 6.36e6) * m, std::acos(-(r * mu + t) / r_t), t * m)[0]).epsilon(1e-5));
    }
}

TEST_CASE("as optical depth goes to zero, radiance is the single-scattering integral") {
    // Air alone, of vertical optical depth 1e-4 over a black ground: the second order is 1e-4 of the first.
    Atmosphere a = earth();
    a.constituents = {constituent("air", ExponentialProfile{8.0 * km}, 1.25e-8, 0.0, RayleighPhase{})};
    a.ground_albedo = SpectrumOf<Number>::constant(0.0);
    const Reference reference = *Reference::of(a, one_wavelength);
    for (const double zenith : {0.2, 1.2, 1.5}) {
        const RadianceEstimate estimate = *reference.radiance({0.0 * m, zenith, 0.6, 0.8}, {.paths = 4096, .seed = 3});
        const double nu = std::cos(zenith) * std::cos(0.6) + std::sin(zenith) * std::sin(0.6) * std::cos(0.8);
        const double mu = std::cos(zenith);
        const double length = f64::distance_to_top(f64::Length::of(0.0), mu, f64::Length::of(6.36e6), f64::Length::of(1e5)).value;
        const double column = exact_column(ExponentialProfile{8.0 * km}, 6.36e6, 0.0, mu, length);
        const double thin = 1.25e-8 * column * f64::rayleigh_phase(nu).value;
        // Extinction takes up to tau / cos(sun) + tau / cos(view) = 4e-3 at the lowest view; four standard errors for the noise.
        CHECK(std::abs(estimate.radiance_W_m2_sr_nm[0] / thin - 1.0) < 5e-3 + 4.0 * estimate.standard_error[0] / thin);
    }
}

TEST_CASE("single scattering is its integral along the view, at any depth") {
    // A homogeneous flat slab, isotropic: first order = albedo / (4 pi) mu_s / (mu_s + mu) (1 - exp(-tau (1 / mu + 1 / mu_s))) from above.
    Atmosphere a;
    a.bottom_radius = 1e11 * m;
    a.top_altitude = 10.0 * km;
    a.constituents = {constituent("slab", LayerProfile{0.0 * m, 10.0 * km}, 1.6e-4, 0.4e-4, IsotropicPhase{})};
    const Reference reference = *Reference::of(a, one_wavelength);
    const double mu = 0.6, mu_s = 0.5, tau = 2.0;
    const RadianceEstimate estimate =
        *reference.radiance({10.0 * km, pi - std::acos(mu), std::acos(mu_s), 0.0}, {.paths = 65536, .last_order = 1});
    const double exact = 0.8 / (4.0 * pi) * mu_s / (mu + mu_s) * (1.0 - std::exp(-tau * (1.0 / mu + 1.0 / mu_s)));
    CHECK(std::abs(estimate.radiance_W_m2_sr_nm[0] - exact) < 4.0 * estimate.standard_error[0] + 1e-5 * exact);
    CHECK(estimate.standard_error[0] < 1e-3 * exact);
}

TEST_CASE("orders of scattering add up to the whole") {
    const Reference reference = *Reference::of(earth(), one_wavelength);
    const View view{1.0 * km, 1.2, 1.0, 0.5};
    double sum = 0.0, variance = 0.0;
    for (int order = 1; order <= 12; ++order) {
        const RadianceEstimate part = *reference.radiance(
            view, {.paths = 16384, .seed = 100u + static_cast<std::uint64_t>(order), .first_order = order, .last_order = order});
        sum += part.radiance_W_m2_sr_nm[0];
        variance += part.standard_error[0] * part.standard_error[0];
    }
    const RadianceEstimate whole = *reference.radiance(view, {.paths = 16384, .seed = 9});
    CHECK(std::abs(sum - whole.radiance_W_m2_sr_nm[0]) < 4.0 * std::hypot(std::sqrt(variance), whole.standard_error[0]));
}

// The mean of trace(u, random) over independent groups of paths, u stratified within each; and its standard error.
std::pair<double, double> mean_over_paths(std::size_t groups, const std::function<double(double, Random&)>& trace) {
    constexpr int size = 256;
    std::vector<double> means(groups);
    parallel_for(groups, [&](std::size_t g) {
        Random random(20260103, g);
        for (int i = 0; i < size; ++i) means[g] += trace((i + random()) / size, random) / size;
    });
    double mean = 0.0, square = 0.0;
    for (const double x : means) mean += x / static_cast<double>(groups);
    for (const double x : means) square += (x - mean) * (x - mean);
    return {mean, std::sqrt(square / static_cast<double>(groups * (groups - 1)))};
}

TEST_CASE("a conservative flat atmosphere over a white ground returns all the light it receives") {
    Atmosphere a = earth(1e11);
    a.constituents[1] =
        constituent("aerosol", ExponentialProfile{1.2 * km}, 2e-4, 0.0, HenyeyGreensteinPhase{SpectrumOf<Number>::constant(0.8)});
    a.constituents.pop_back();
    a.ground_albedo = SpectrumOf<Number>::constant(1.0);
    const PathTracer tracer(air_optics(a, one_wavelength),
                            std::make_shared<const Columns>(path_densities(a), f64::Length::of(1e11), f64::Length::of(1e5)));
    const Vec3 up(0.0, 0.0, 1.0), sun(0.6, 0.0, 0.8);
    const auto [mean, error] = mean_over_paths(1500, [&](double u, Random& random) {
        // What leaves the top: pi times the mean over directions drawn by their cosine.
        const Vec3 down = turned(-up, std::sqrt(u), 2.0 * pi * random());
        return pi * tracer.radiance({1e5, up, down, sun}, {1, 1000000}, 0, random(), random).v[0] / 0.8;
    });
    fmt::print("  reflected {:.5f} of the light received, standard error {:.5f}\n", mean, error);
    CHECK(std::abs(mean - 1.0) < std::min(0.002 + error, 4.0 * error));
    CHECK(error < 0.002);
}

TEST_CASE("a conservative planet with a white ground scatters all the light that it takes from the sun's beam") {
    Atmosphere a = earth(2e5);  // a small planet, half of it air: rays that skim it matter
    a.constituents[1] =
        constituent("aerosol", ExponentialProfile{6.0 * km}, 4e-5, 0.0, HenyeyGreensteinPhase{SpectrumOf<Number>::constant(0.6)});
    a.constituents.pop_back();
    a.ground_albedo = SpectrumOf<Number>::constant(1.0);
    const double bottom = 2e5, top = 1e5, radius = bottom + top;
    const PathTracer tracer(air_optics(a, one_wavelength),
                            std::make_shared<const Columns>(path_densities(a), f64::Length::of(bottom), f64::Length::of(top)));
    // The beam loses 1 - T over its cross-section; what meets the ground is returned too.
    const GaussRule rule = gauss_rule(400, 0.0, 1.0);
    double taken = pi * bottom * bottom;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const double b = bottom + (radius - bottom) * rule.nodes[i];
        const double mu = -std::sqrt(1.0 - b * b / (radius * radius));
        taken += rule.weights[i] * (radius - bottom) * 2.0 * pi * b * (1.0 - tracer.transmittance_to_top(top, mu).v[0]);
    }
    const auto [mean, error] = mean_over_paths(4000, [&](double u, Random& random) {
        // Over the whole sphere of the top and all directions outwards.
        const Vec3 up(0.0, 0.0, 1.0);
        const Vec3 sun = turned(up, 2.0 * u - 1.0, 2.0 * pi * random());
        const Vec3 down = turned(-up, std::sqrt(random()), 2.0 * pi * random());
        return 4.0 * pi * radius * radius * pi * tracer.radiance({top, up, down, sun}, {1, 1000000}, 0, random(), random).v[0] / taken;
    });
    fmt::print("  scattered {:.5f} of the light taken, standard error {:.5f}\n", mean, error);
    CHECK(std::abs(mean - 1.0) < std::min(0.002 + error, 4.0 * error));
    CHECK(error < 0.002);
}

TEST_CASE("reciprocity: exchanging eye and sun keeps radiance over the cosine of the exit, above a flat atmosphere") {
    // R(mu, mu_s) mu_s^-1 is symmetric for what leaves the top. [Chandrasekhar1960, section 52]
    const Reference reference = *Reference::of(earth(1e11), one_wavelength);
    const double a = 0.5, b = 1.2;
    const RadianceEstimate there = *reference.radiance({100.0 * km, pi - a, b, 1.0}, {.paths = 65536, .seed = 4});
    const RadianceEstimate back = *reference.radiance({100.0 * km, pi - b, a, 1.0}, {.paths = 65536, .seed = 5});
    const double x = there.radiance_W_m2_sr_nm[0] / std::cos(b), y = back.radiance_W_m2_sr_nm[0] / std::cos(a);
    const double error = std::hypot(there.standard_error[0] / std::cos(b), back.standard_error[0] / std::cos(a));
    CHECK(std::abs(x - y) < 4.0 * error);
    CHECK(error < 0.005 * x);
}

TEST_CASE("the same seed gives the same bits on any number of threads") {
    std::vector<Wavelength> wavelengths;
    for (int i = 0; i < 20; ++i) wavelengths.push_back((400.0 + 10.0 * i) * nm);
    const Reference reference = *Reference::of(earth(), wavelengths);
    const auto run = [&](int threads) {
        const ThreadLimit limit(threads);
        return *reference.radiance({0.0 * m, 1.0, 1.0, 0.3}, {.paths = 20000, .seed = 42});
    };
    const RadianceEstimate one = run(1);
    REQUIRE(one.radiance_W_m2_sr_nm.size() == 20);
    for (const int threads : {2, 5}) {
        const RadianceEstimate other = run(threads);
        CHECK(other.radiance_W_m2_sr_nm == one.radiance_W_m2_sr_nm);
        CHECK(other.standard_error == one.standard_error);
    }
    CHECK(run(2).radiance_W_m2_sr_nm != (*reference.radiance({0.0 * m, 1.0, 1.0, 0.3}, {.paths = 20000, .seed = 43})).radiance_W_m2_sr_nm);
}

TEST_CASE("an irradiance is the sky's radiance over the hemisphere, by cosine, the direct part is the beam's") {
    const Reference reference = *Reference::of(earth(), one_wavelength);
    const IrradianceEstimate irradiance = *reference.irradiance(0.0 * m, 0.7, {.paths = 65536});
    CHECK(irradiance.direct_W_m2_nm[0] ==
          doctest::Approx(std::cos(0.7) * reference.transmittance(0.0 * m, 0.7, 1e6 * m)[0]).epsilon(1e-12));
    // Gauss in cosine^2 and the trapezoid in azimuth; the aureole is coarse on this grid, so half a percent and four standard errors.
    const GaussRule rule = gauss_rule(12, 0.0, 1.0);
    double sum = 0.0, variance = 0.0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i)
        for (int k = 0; k < 16; ++k) {
            const RadianceEstimate sky = *reference.radiance({0.0 * m, std::acos(std::sqrt(rule.nodes[i])), 0.7, pi * (k + 0.5) / 16.0},
                                                             {.paths = 512, .seed = i * 16 + static_cast<std::size_t>(k)});
            sum += pi * rule.weights[i] / 16.0 * sky.radiance_W_m2_sr_nm[0];
            variance += std::pow(pi * rule.weights[i] / 16.0 * sky.standard_error[0], 2);
        }
    CHECK(std::abs(sum - irradiance.diffuse_W_m2_nm[0]) <
          4.0 * std::hypot(std::sqrt(variance), irradiance.standard_error[0]) + 0.005 * sum);
}

TEST_CASE("a sun of half a degree lights the sky as a point does, and its edge is darker where the limb is") {
    Atmosphere a = earth();
    const View view{0.0 * m, 1.0, 0.5, 2.0};
    const RadianceEstimate point = *Reference::of(a, one_wavelength)->radiance(view, {.paths = 65536});
    a.sun.angular_radius = 0.265 * deg;
    a.sun.limb_darkening_1 = SpectrumOf<Number>::constant(0.5);
    a.sun.limb_darkening_2 = SpectrumOf<Number>::constant(0.2);
    const RadianceEstimate disk = *Reference::of(a, one_wavelength)->radiance(view, {.paths = 65536, .seed = 8});
    CHECK(std::abs(point.radiance_W_m2_sr_nm[0] - disk.radiance_W_m2_sr_nm[0]) <
          4.0 * std::hypot(point.standard_error[0], disk.standard_error[0]));
    std::array<Wavelength, pack_size> wavelengths;
    wavelengths.fill(550.0 * nm);
    const SunSampler sampler(a.sun, wavelengths);
    double mean = 0.0;
    for (int i = 0; i < 10000; ++i) mean += sampler.weight((i + 0.5) / 10000.0).v[0] / 10000.0;
    CHECK(mean == doctest::Approx(1.0).epsilon(1e-4));
    CHECK(sampler.weight(0.999).v[0] < 0.5 * sampler.weight(0.0).v[0]);
}

TEST_CASE("no query of the whole domain gives a NaN, an infinity or a negative radiance") {
    std::mt19937_64 random(20260102);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (const double radius : {1e5, 6.36e6, 7e7, 1e11}) {
        const Reference reference = *Reference::of(earth(radius), one_wavelength);
        for (int i = 0; i < 1500; ++i) {
            const double altitude = i % 4 == 0   ? 0.0
                                    : i % 4 == 1 ? 1e5
                                                 : 1e5 * std::pow(uniform(random), 3.0) * (i % 4 == 2 ? 1000.0 : 1.0);
            const View view{altitude * m, pi * uniform(random), pi * uniform(random), 2.0 * pi * uniform(random)};
            const RadianceEstimate estimate = *reference.radiance(view, {.paths = 128, .seed = static_cast<std::uint64_t>(i)});
            const double x = estimate.radiance_W_m2_sr_nm[0], e = estimate.standard_error[0];
            if (!(x >= 0.0 && x < 1.0 && e >= 0.0 && e < 10.0)) {
                CAPTURE(radius);
                CAPTURE(altitude);
                CAPTURE(view.view_zenith);
                CAPTURE(view.sun_zenith);
                CAPTURE(x);
                CHECK(std::isfinite(x));
                CHECK(x >= 0.0);
                CHECK(x < 1.0);
            }
        }
    }
}

TEST_CASE("an eye below the ground, no wavelength, or no path is an error that says so, a view that misses the air is black") {
    const Reference reference = *Reference::of(earth(), one_wavelength);
    const auto below = reference.radiance({-5.0 * m, 0.0, 0.0, 0.0}, {});
    REQUIRE(!below);
    CHECK(below.error().message().find("5 m below the ground") != std::string::npos);
    CHECK(!reference.radiance({0.0 * m, std::nan(""), 0.0, 0.0}, {}));
    CHECK(!reference.radiance({0.0 * m, 0.0, 0.0, 0.0}, {.paths = 0}));
    CHECK(!Reference::of(earth(), {}));
    std::stop_source stop;
    stop.request_stop();
    CHECK(!reference.radiance({0.0 * m, 0.0, 0.0, 0.0}, {}, {.stop = stop.get_token()}));
    CHECK((*reference.radiance({400.0 * km, 1.0, 0.5, 0.0}, {})).radiance_W_m2_sr_nm[0] == 0.0);
}

TEST_CASE("vectors and angles name the same query") {
    const Reference reference = *Reference::of(earth(), one_wavelength);
    const RadianceEstimate angles = *reference.radiance({2.0 * km, 0.9, 0.4, 0.0}, {.paths = 4096});
    const RadianceEstimate vectors = *reference.radiance(Vec3(0.0, 0.0, 6.362e6), Vec3(std::sin(0.9), 0.0, std::cos(0.9)),
                                                         Vec3(std::sin(0.4), 0.0, std::cos(0.4)), {.paths = 4096});
    CHECK(vectors.radiance_W_m2_sr_nm[0] == doctest::Approx(angles.radiance_W_m2_sr_nm[0]).epsilon(1e-6));
}

TEST_CASE("what the air before a point adds, and the light from the point as far as it comes through, are what is seen") {
    const Reference reference = *Reference::of(earth(), one_wavelength);
    const double bottom = 6.36e6, altitude = 5e3;
    const Vec3 eye(0.0, 0.0, bottom + altitude);
    for (const double sun_deg : {40.0, 88.0})
        for (const double zenith_deg : {60.0, 91.5, 120.0}) {  // up, past the point nearest to the ground, and down to it
            const double zenith = zenith_deg * deg;
            const Vec3 direction(std::sin(zenith), 0.0, std::cos(zenith)), sun(std::sin(sun_deg * deg), 0.0, std::cos(sun_deg * deg));
            const View view{altitude * m, zenith, sun_deg * deg, 0.0};
            const RadianceEstimate whole = *reference.radiance(view, {.paths = 65536});
            for (const double distance : {2e3, 9e3}) {
                CAPTURE(sun_deg);
                CAPTURE(zenith_deg);
                CAPTURE(distance);
                const RadianceEstimate near = *reference.inscattered(view, distance * m, {.paths = 65536, .seed = 2});
                const RadianceEstimate far = *reference.radiance(eye + distance * direction, direction, sun, {.paths = 65536, .seed = 3});
                const double seen = reference.transmittance(altitude * m, zenith, distance * m)[0];
                const double error = std::hypot(whole.standard_error[0], near.standard_error[0], seen * far.standard_error[0]);
                CHECK(std::abs(near.radiance_W_m2_sr_nm[0] + seen * far.radiance_W_m2_sr_nm[0] - whole.radiance_W_m2_sr_nm[0]) <
                      4.0 * error);
                CHECK(near.standard_error[0] < 0.02 * near.radiance_W_m2_sr_nm[0]);
            }
        }
}

TEST_CASE("beyond the air there is nothing to add: in-scattered light over the whole way is the radiance, to the bit") {
    const Reference reference = *Reference::of(earth(), one_wavelength);
    const View up{2.0 * km, 70.0 * deg, 50.0 * deg, 30.0 * deg};
    CHECK(reference.inscattered(up, 1e9 * m, {.paths = 256})->radiance_W_m2_sr_nm ==
          reference.radiance(up, {.paths = 256})->radiance_W_m2_sr_nm);
    const View down{2.0 * km, 130.0 * deg, 50.0 * deg, 30.0 * deg};
    CHECK(reference.inscattered(down, 1e9 * m, {.paths = 4096})->radiance_W_m2_sr_nm[0] <
          reference.radiance(down, {.paths = 4096})->radiance_W_m2_sr_nm[0]);
    CHECK(reference.inscattered({400.0 * km, 0.0, 0.0, 0.0}, 1.0 * km, {}).error().message().find("outside the air") != std::string::npos);
    CHECK(!reference.inscattered(up, 0.0 * m, {}));
}
