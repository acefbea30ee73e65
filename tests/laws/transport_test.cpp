// An atmosphere at a pack of wavelengths.

#include <doctest/doctest.h>

#include "core/quadrature.h"
#include "transport/air_optics.h"

using namespace airlight;

TEST_CASE("Gauss's rule integrates polynomials exactly") {
    for (const int n : {1, 2, 5, 64}) {
        const GaussRule rule = gauss_rule(n, 0.0, 2.0);
        double integral = 0.0;
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) integral += rule.weights[i] * std::pow(rule.nodes[i], 2 * n - 1);
        CHECK(integral == doctest::Approx(std::pow(2.0, 2 * n) / (2 * n)).epsilon(1e-12));
    }
}

TEST_CASE("the Legendre moments of Henyey and Greenstein's phase function are the powers of g, Rayleigh's end at the second") {
    std::array<Wavelength, pack_size> wavelengths;
    wavelengths.fill(550.0 * nm);
    const auto hg = SpectralPhase(HenyeyGreensteinPhase{SpectrumOf<Number>::constant(0.8)}, wavelengths).legendre_moments(20);
    for (int l = 0; l < 20; ++l) CHECK(hg[static_cast<std::size_t>(l)].v[3] == doctest::Approx(std::pow(0.8, l)).epsilon(1e-9));
    const auto rayleigh = SpectralPhase(RayleighPhase{}, wavelengths).legendre_moments(6);
    const double expected[] = {1.0, 0.0, 0.1, 0.0, 0.0, 0.0};
    for (int l = 0; l < 6; ++l) CHECK(rayleigh[static_cast<std::size_t>(l)].v[0] == doctest::Approx(expected[l]).epsilon(1e-9));
}

TEST_CASE("a column depth is the closed form of its profile") {
    CHECK(column_depth(ExponentialProfile{8.0 * km}, 100.0 * km).value == doctest::Approx(8000.0 * (1.0 - std::exp(-12.5))).epsilon(1e-9));
    CHECK(column_depth(ExponentialProfile{50.0 * m}, 100.0 * km).value == doctest::Approx(50.0).epsilon(1e-9));
    CHECK(column_depth(TriangleProfile{10.0 * km, 25.0 * km, 40.0 * km}, 100.0 * km).value == doctest::Approx(15000.0).epsilon(1e-12));
    CHECK(column_depth(LayerProfile{1.0 * km, 3.0 * km}, 2.0 * km).value == doctest::Approx(1000.0).epsilon(1e-12));
}
