#include "optics/mie.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

namespace airlight {

namespace {

using Complex = std::complex<double>;

// Products and inverses without the library's checks for infinities, which cost more than the arithmetic.
Complex product(Complex a, Complex b) { return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()}; }
Complex inverse(Complex a) { return std::conj(a) / std::norm(a); }

// Where a downward recurrence must start so that a start from zero is forgotten above order n and argument z:
// the ratio of the two solutions is exp(-4/3 t^(3/2)), t = (order - z) / (z / 2)^(1/3), and 7.5 z^(1/3) makes it 1e-17.
std::size_t start_order(std::size_t n, double z) {
    return static_cast<std::size_t>(std::max(static_cast<double>(n), z) + 8.0 * std::cbrt(z)) + 16;
}

// psi_n'(z) / psi_n(z) for n = 1 .. count, element i of order i + 1.
std::vector<Complex> logarithmic_derivatives(Complex z, std::size_t count) {
    std::vector<Complex> result(count);
    const Complex inverse_z = inverse(z);
    Complex d = 0.0;
    for (std::size_t n = start_order(count, std::abs(z)); n > 1; --n) {
        const Complex n_over_z = static_cast<double>(n) * inverse_z;
        d = n_over_z - inverse(d + n_over_z);
        if (n - 1 <= count) result[n - 2] = d;
    }
    return result;
}

// psi_n(x) for n = 0 .. count.
std::vector<double> riccati_bessel_psi(double x, std::size_t count) {
    std::vector<double> psi(count + 1);
    psi[0] = std::sin(x);
    const std::size_t oscillating = std::min(count, static_cast<std::size_t>(x));
    for (std::size_t n = 1; n <= oscillating; ++n)
        psi[n] = (2.0 * static_cast<double>(n) - 1.0) / x * psi[n - 1] - (n == 1 ? std::cos(x) : psi[n - 2]);
    // Beyond n = x they decay and the upward recurrence would drown them: the ratios psi_n / psi_(n-1), downward.
    double ratio = 0.0;
    for (std::size_t n = start_order(count, x); n > oscillating; --n) {
        ratio = x / (2.0 * static_cast<double>(n) + 1.0 - x * ratio);
        if (n <= count) psi[n] = ratio;
    }
    for (std::size_t n = oscillating + 1; n <= count; ++n) psi[n] *= psi[n - 1];
    return psi;
}

// A multipole: l psi_n - psi_(n-1) over the same of xi = psi + i chi, where l = D / m + n / x for a_n and m D + n / x for b_n.
struct Multipole {
    Complex coefficient;
    double absorbed;  // Re(coefficient) - |coefficient|^2
};

struct RadialFunctions {
    double psi, psi_before, chi, chi_before;
};

Multipole multipole(Complex l, const RadialFunctions& f) {
    const Complex inner = l * f.psi - f.psi_before;
    const Complex outer = l * f.chi - f.chi_before;
    const Complex sum(inner.real() - outer.imag(), inner.imag() + outer.real());
    const double norm = std::norm(sum);
    // With the Wronskian psi_(n-1) chi_n - psi_n chi_(n-1) = 1, what is absorbed is Im(l) / |sum|^2.
    return {product(inner, std::conj(sum)) / norm, l.imag() / norm};
}

double sign(std::size_t n) { return n % 2 == 0 ? 1.0 : -1.0; }

}  // namespace

std::size_t mie_term_count(double x) { return static_cast<std::size_t>(x + 4.05 * std::cbrt(x) + 2.0); }

MieSeries mie_series(double x, RefractiveIndex index) {
    assert(x >= 1e-30 && x <= 1e5 && index.n > 0.0 && index.k >= 0.0);
    const std::size_t count = mie_term_count(x);
    const Complex m(index.n, -index.k);
    const Complex inverse_m = inverse(m);
    const std::vector<Complex> d = logarithmic_derivatives(m * x, count);
    const std::vector<double> psi = riccati_bessel_psi(x, count);

    MieSeries series{x, 0.0, std::vector<Complex>(count), std::vector<Complex>(count)};
    double chi_before = std::cos(x);
    double chi = std::cos(x) / x + std::sin(x);
    for (std::size_t i = 0; i < count; ++i) {
        const double n = static_cast<double>(i + 1);
        const RadialFunctions f{psi[i + 1], psi[i], chi, chi_before};
        const Multipole electric = multipole(product(d[i], inverse_m) + n / x, f);
        const Multipole magnetic = multipole(product(d[i], m) + n / x, f);
        series.a[i] = electric.coefficient;
        series.b[i] = magnetic.coefficient;
        series.qabs += 2.0 / (x * x) * (2.0 * n + 1.0) * (electric.absorbed + magnetic.absorbed);
        chi_before = std::exchange(chi, (2.0 * n + 1.0) / x * chi - chi_before);
    }
    return series;
}

MieEfficiencies mie_efficiencies(const MieSeries& series) {
    double extinction = 0.0;
    double scattering = 0.0;
    double forward = 0.0;
    Complex back = 0.0;
    for (std::size_t i = 0; i < series.a.size(); ++i) {
        const double n = static_cast<double>(i + 1);
        const Complex a = series.a[i];
        const Complex b = series.b[i];
        extinction += (2.0 * n + 1.0) * (a + b).real();
        scattering += (2.0 * n + 1.0) * (std::norm(a) + std::norm(b));
        back += (2.0 * n + 1.0) * sign(i + 1) * (a - b);
        forward += (2.0 * n + 1.0) / (n * (n + 1.0)) * product(a, std::conj(b)).real();
        if (i + 1 == series.a.size()) break;
        forward += n * (n + 2.0) / (n + 1.0) * (product(a, std::conj(series.a[i + 1])) + product(b, std::conj(series.b[i + 1]))).real();
    }
    const double inverse_x2 = 1.0 / (series.x * series.x);
    return {2.0 * inverse_x2 * extinction, 2.0 * inverse_x2 * scattering, series.qabs, inverse_x2 * std::norm(back),
            scattering > 0.0 ? 2.0 * forward / scattering : 0.0};
}

MieEfficiencies mie_efficiencies(double x, RefractiveIndex index) { return mie_efficiencies(mie_series(x, index)); }

MieAmplitudes mie_amplitudes(const MieSeries& series, double nu) {
    MieAmplitudes sum{0.0, 0.0};
    double pi_before = 0.0;
    double pi_n = 1.0;
    for (std::size_t i = 0; i < series.a.size(); ++i) {
        const double n = static_cast<double>(i + 1);
        const double tau_n = n * nu * pi_n - (n + 1.0) * pi_before;
        const double factor = (2.0 * n + 1.0) / (n * (n + 1.0));
        sum.s1 += factor * (series.a[i] * pi_n + series.b[i] * tau_n);
        sum.s2 += factor * (series.a[i] * tau_n + series.b[i] * pi_n);
        pi_before = std::exchange(pi_n, ((2.0 * n + 1.0) * nu * pi_n - (n + 1.0) * pi_before) / n);
    }
    return sum;
}

double mueller_11(const MieAmplitudes& amplitudes) { return 0.5 * (std::norm(amplitudes.s1) + std::norm(amplitudes.s2)); }

double polarisation(const MieAmplitudes& amplitudes) {
    const double s1 = std::norm(amplitudes.s1);
    const double s2 = std::norm(amplitudes.s2);
    return s1 + s2 > 0.0 ? (s1 - s2) / (s1 + s2) : 0.0;
}

}  // namespace airlight
