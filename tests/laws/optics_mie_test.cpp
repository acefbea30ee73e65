// Mie's series: Wiscombe's printed values, the laws that any sphere obeys, and its limits.

#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <initializer_list>
#include <numbers>

#include "core/quadrature.h"
#include "optics/mie.h"

using namespace airlight;

namespace {

struct Sphere {
    double x;
    RefractiveIndex index;
};

constexpr double pi = std::numbers::pi;

// From tiny to large, transparent to metallic, below and above the index of what surrounds it.
const std::initializer_list<Sphere> spheres = {
    {1e-12, {1.5, 0.1}}, {1e-3, {1.33, 0.0}},   {0.1, {1.5, 1.0}},     {1.0, {0.75, 0.0}},   {3.14159265358979, {1.5, 0.01}},
    {10.0, {1.5, 0.0}},  {100.0, {1.33, 1e-5}}, {100.0, {10.0, 10.0}}, {1000.0, {1.5, 1.0}}, {3000.0, {1.33, 1e-9}},
};

double rounded(double value) { return std::round(value * 1e6) / 1e6; }

// The integrals over the sphere of M11 and of M11 nu, by a Gauss rule that is exact for the products of the series' terms.
std::pair<double, double> integrals_of_m11(const MieSeries& series) {
    const GaussRule rule = gauss_rule(static_cast<int>(series.a.size()) + 2);
    std::pair<double, double> sum{0.0, 0.0};
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const double share = 2.0 * pi * rule.weights[i] * mueller_11(mie_amplitudes(series, rule.nodes[i]));
        sum.first += share;
        sum.second += share * rule.nodes[i];
    }
    return sum;
}

}  // namespace

// [Wiscombe1979, tables of test cases], all printed digits.
TEST_CASE("efficiencies and mean cosines are Wiscombe's to all printed digits") {
    const auto same = [](const Sphere& sphere, double qext, double qsca, double g) {
        CAPTURE(sphere.x);
        const MieEfficiencies e = mie_efficiencies(sphere.x, sphere.index);
        CHECK(rounded(e.qext) == qext);
        CHECK(rounded(e.qsca) == qsca);
        CHECK(rounded(e.g) == g);
    };
    same({10.0, {1.5, 0.0}}, 2.881999, 2.881999, 0.742913);
    same({100.0, {1.5, 0.0}}, 2.094388, 2.094388, 0.818246);
    same({100.0, {1.33, 1e-5}}, 2.101321, 2.096594, 0.868959);
    same({100.0, {1.5, 1.0}}, 2.097502, 1.283697, 0.850252);
    same({100.0, {10.0, 10.0}}, 2.071124, 1.836785, 0.556215);
}

TEST_CASE("energy is conserved: what a sphere takes from the beam it scatters or absorbs, and without k it absorbs nothing") {
    for (const Sphere& sphere : spheres) {
        CAPTURE(sphere.x);
        const MieEfficiencies e = mie_efficiencies(sphere.x, sphere.index);
        // Each is a sum of its own of up to 3000 positive terms; the upward chi loses a few digits more.
        CHECK(e.qext == doctest::Approx(e.qsca + e.qabs).epsilon(1e-11));
        CHECK(e.qabs >= 0.0);
        if (sphere.index.k == 0.0) CHECK(e.qabs == 0.0);
    }
}

TEST_CASE("optical theorem: the forward amplitude tells the extinction") {
    for (const Sphere& sphere : spheres) {
        CAPTURE(sphere.x);
        const MieSeries series = mie_series(sphere.x, sphere.index);
        const MieAmplitudes forward = mie_amplitudes(series, 1.0);
        CHECK(4.0 / (sphere.x * sphere.x) * forward.s1.real() == doctest::Approx(mie_efficiencies(series).qext).epsilon(1e-11));
        CHECK(std::abs(forward.s1 - forward.s2) <= 1e-12 * std::abs(forward.s1));
    }
}

TEST_CASE("the light scattered over all directions is the scattering cross-section, and its mean cosine is g") {
    for (const Sphere& sphere : spheres) {
        if (sphere.x > 200.0) continue;  // the sum over angles costs x^2
        CAPTURE(sphere.x);
        const MieSeries series = mie_series(sphere.x, sphere.index);
        const MieEfficiencies e = mie_efficiencies(series);
        const auto [integral, forward] = integrals_of_m11(series);
        CHECK(integral == doctest::Approx(pi * sphere.x * sphere.x * e.qsca).epsilon(1e-11));
        CHECK(std::abs(forward / integral - e.g) < 1e-11);
    }
}

TEST_CASE("backscattering is the amplitude at 180 degrees") {
    for (const Sphere& sphere : spheres) {
        CAPTURE(sphere.x);
        const MieSeries series = mie_series(sphere.x, sphere.index);
        const MieAmplitudes back = mie_amplitudes(series, -1.0);
        const double qback = 4.0 * mueller_11(back) / (sphere.x * sphere.x);
        // The alternating sum of terms up to x cancels: x / sqrt(qback) of its digits are lost.
        CHECK(mie_efficiencies(series).qback == doctest::Approx(qback).epsilon(1e-9));
    }
}

TEST_CASE("a tiny sphere scatters as Rayleigh says, to the smallest sizes") {
    for (const double x : {1e-20, 1e-8, 1e-4, 1e-3}) {
        for (const RefractiveIndex index : {RefractiveIndex{1.33, 0.0}, RefractiveIndex{1.5, 0.0}, RefractiveIndex{1.75, 0.44}}) {
            CAPTURE(x);
            const std::complex<double> m(index.n, -index.k);
            const std::complex<double> polarisability = (m * m - 1.0) / (m * m + 2.0);
            const MieSeries series = mie_series(x, index);
            const MieEfficiencies e = mie_efficiencies(series);
            // The next terms are of the order of x^2 <= 1e-6; [BohrenHuffman1983, eq. 5.7 and 5.8].
            CHECK(e.qsca == doctest::Approx(8.0 / 3.0 * std::pow(x, 4) * std::norm(polarisability)).epsilon(3e-6));
            CHECK(e.qabs == doctest::Approx(-4.0 * x * polarisability.imag()).epsilon(3e-6));
            CHECK(std::abs(e.g) < 1e-6);
            // Twice as much along the beam as across it, where it is fully polarised.
            CHECK(mueller_11(mie_amplitudes(series, 1.0)) / mueller_11(mie_amplitudes(series, 0.0)) == doctest::Approx(2.0).epsilon(3e-6));
            CHECK(polarisation(mie_amplitudes(series, 0.0)) == doctest::Approx(1.0).epsilon(1e-9));
        }
    }
}

TEST_CASE("extinction paradox: a large sphere takes twice its shadow from the beam") {
    for (const RefractiveIndex index :
         {RefractiveIndex{1.33, 0.0}, RefractiveIndex{1.33, 1e-5}, RefractiveIndex{1.5, 1.0}, RefractiveIndex{10.0, 10.0}}) {
        const MieEfficiencies e = mie_efficiencies(1e4, index);
        // The edge adds 2 x^(-2/3) = 0.0043, and transparent spheres ripple by as much. [vandeHulst1957, sec. 17.22]
        CHECK(e.qext == doctest::Approx(2.0 + 1.992 * std::pow(1e4, -2.0 / 3.0)).epsilon(3e-3));
        CHECK(e.qsca <= e.qext);
        CHECK(e.g > 0.5);
    }
}

TEST_CASE("a strongly absorbing large sphere absorbs what enters it and reflects the rest") {
    // Geometric optics: of the light that meets the surface, w = the mean reflectance of unpolarised light, returns;
    // qsca = 1 + w, the 1 by diffraction. For 1.5 - i, w by the integral of Fresnel's coefficients over the disk.
    const std::complex<double> m(1.5, -1.0);
    const GaussRule rule = gauss_rule(64, 0.0, 1.0);
    double reflected = 0.0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const double c = rule.nodes[i];
        const std::complex<double> inside = std::sqrt(m * m - 1.0 + c * c);
        const std::complex<double> across = (c - inside) / (c + inside);
        const std::complex<double> along = (m * m * c - inside) / (m * m * c + inside);
        reflected += 2.0 * c * rule.weights[i] * 0.5 * (std::norm(across) + std::norm(along));
    }
    // Corrections fall as x^(-2/3): 2e-3 at x = 1e4.
    CHECK(mie_efficiencies(1e4, {1.5, 1.0}).qsca == doctest::Approx(1.0 + reflected).epsilon(5e-3));
}

TEST_CASE("a sphere of the index of its surroundings is invisible") {
    const MieEfficiencies e = mie_efficiencies(5.0, {1.0, 0.0});
    CHECK(std::abs(e.qext) < 1e-14);
    CHECK(e.qabs == 0.0);
}
