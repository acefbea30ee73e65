// Spheres of many sizes: what their mean particle does, against single spheres and closed forms.

#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "core/quadrature.h"
#include "optics/size_distribution.h"

using namespace airlight;

namespace {

constexpr Wavelength green = 550.0 * nm;

LognormalSizes uncut(Length mode_radius, double sigma) { return {mode_radius, sigma, 1e-12 * m, 1.0 * m}; }

MieAngles angles_of(const std::vector<double>& cosines, const LognormalSizes& sizes) {
    return MieAngles(cosines, series_terms(sizes, green));
}

}  // namespace

TEST_CASE("M11 at many angles is that of the amplitudes at each") {
    std::vector<double> cosines;
    for (int degrees = 0; degrees <= 180; degrees += 7) cosines.push_back(std::cos(degrees * deg));
    const MieSeries series = mie_series(50.0, {1.5, 0.01});
    const MieAngles angles(cosines, series.a.size() + 3);
    std::vector<double> sum(cosines.size(), 1.0);
    angles.add_mueller_11(series, 2.0, sum);
    for (std::size_t i = 0; i < cosines.size(); ++i)
        CHECK(sum[i] - 1.0 == doctest::Approx(2.0 * mueller_11(mie_amplitudes(series, cosines[i]))).epsilon(1e-10));
}

TEST_CASE("a lognormal distribution counts one particle, and its cuts take particles away") {
    const auto count = [](const LognormalSizes& sizes) {
        double sum = 0.0;
        for (double l = -40.0; l < 5.0; l += 1e-3) sum += 1e-3 * number_per_log_radius(sizes, std::exp(l) * m);
        return sum;
    };
    CHECK(count(uncut(0.1 * um, 2.0)) == doctest::Approx(1.0).epsilon(1e-12));
    // Half of the particles lie below the mode radius.
    CHECK(count({0.1 * um, 2.0, 1e-12 * m, 0.1 * um}) == doctest::Approx(0.5).epsilon(1e-3));
}

TEST_CASE("a distribution of one size is one sphere") {
    // sigma = 1.00001: sizes within 1e-5, over which efficiencies at x = 11 change by 1e-4 at most.
    const LognormalSizes sizes = uncut(1.0 * um, 1.00001);
    const RefractiveIndex index{1.5, 0.01};
    const double x = 2.0 * pi * 1000.0 / 550.0;
    const MieEfficiencies sphere = mie_efficiencies(x, index);
    const MeanParticle mean = mean_particle(sizes, index, green, angles_of({1.0, -0.3}, sizes));
    CHECK(mean.scattering.in(m2) == doctest::Approx(sphere.qsca * pi * 1e-12).epsilon(1e-4));
    CHECK(mean.absorption.in(m2) == doctest::Approx(sphere.qabs * pi * 1e-12).epsilon(1e-4));
    CHECK(mean.g == doctest::Approx(sphere.g).epsilon(1e-4));
    const double m11 = mueller_11(mie_amplitudes(mie_series(x, index), -0.3));
    CHECK(mean.scattering_m2_sr[1] == doctest::Approx(m11 * std::pow(550e-9 / (2.0 * pi), 2)).epsilon(1e-3));
}

TEST_CASE("particles small against the wavelength scatter by their mean r^6 and absorb by their mean r^3") {
    const double s = std::log(1.8);
    const double r = 1e-10;  // even the mode of r^6, 0.8 nm, is far below the wavelength
    const LognormalSizes sizes = uncut(r * m, 1.8);
    const std::complex<double> index(1.75, -0.44);
    const std::complex<double> polarisability = (index * index - 1.0) / (index * index + 2.0);
    const MeanParticle mean = mean_particle(sizes, {1.75, 0.44}, green, angles_of({1.0}, sizes));
    const double wavenumber = 2.0 * pi / 550e-9;
    // The mean of r^p is r^p exp(p^2 s^2 / 2); corrections of the order of x^2 = 1e-4 at the sizes that scatter most.
    const double scattering =
        8.0 / 3.0 * pi * std::pow(wavenumber, 4) * std::pow(r, 6) * std::exp(18.0 * s * s) * std::norm(polarisability);
    const double absorption = -4.0 * pi * wavenumber * std::pow(r, 3) * std::exp(4.5 * s * s) * polarisability.imag();
    CHECK(mean.scattering.in(m2) == doctest::Approx(scattering).epsilon(2e-3));
    CHECK(mean.absorption.in(m2) == doctest::Approx(absorption).epsilon(1e-3));
}

TEST_CASE("the mean scattering over all directions is the mean cross-section, and its mean cosine is g") {
    const LognormalSizes sizes{0.2 * um, 2.0, 0.005 * um, 5.0 * um};
    const GaussRule rule = gauss_rule(static_cast<int>(series_terms(sizes, green)) + 2);  // exact for products of the series' terms
    const MeanParticle mean = mean_particle(sizes, {1.45, 0.003}, green, angles_of(rule.nodes, sizes), 0.1);
    double integral = 0.0;
    double forward = 0.0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const double share = 2.0 * pi * rule.weights[i] * mean.scattering_m2_sr[i];
        integral += share;
        forward += share * rule.nodes[i];
    }
    CHECK(integral == doctest::Approx(mean.scattering.in(m2)).epsilon(1e-11));
    CHECK(forward / integral == doctest::Approx(mean.g).epsilon(1e-10));
}

TEST_CASE("the mean over sizes converges: a quarter of the default step changes coefficients by less than 5e-4") {
    // Coarse sea salt in moist air: large, transparent, with narrow resonances; the hardest of the components.
    const LognormalSizes sizes{3.49 * um, 2.03, 0.009 * um, 40.0 * um};
    const MieAngles angles = angles_of({1.0, 0.5, 0.0}, sizes);
    const MeanParticle usual = mean_particle(sizes, {1.352, 2e-9}, green, angles);
    const MeanParticle fine = mean_particle(sizes, {1.352, 2e-9}, green, angles, 0.25 * default_log_step);
    CHECK((usual.scattering / fine.scattering).value == doctest::Approx(1.0).epsilon(5e-4));
    CHECK(usual.g == doctest::Approx(fine.g).epsilon(2e-3));
    CHECK(usual.scattering_m2_sr[0] == doctest::Approx(fine.scattering_m2_sr[0]).epsilon(5e-3));
    CHECK(usual.scattering_m2_sr[1] == doctest::Approx(fine.scattering_m2_sr[1]).epsilon(2e-2));
}
