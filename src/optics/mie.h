// Scattering of a plane wave by a homogeneous sphere: Mie's series.
// Theory: docs/theory.md, section 3.3; [Mie1908], in the notation of [BohrenHuffman1983, ch. 4]. Uses nothing of the project.
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

namespace airlight {

// The refractive index n - ik of a sphere relative to what surrounds it; n > 0, and k >= 0 absorbs.
struct RefractiveIndex {
    double n = 1.0;
    double k = 0.0;
    friend bool operator==(const RefractiveIndex&, const RefractiveIndex&) = default;
};

// Cross-sections divided by the sphere's geometric one, pi r^2.
struct MieEfficiencies {
    double qext;   // extinction: what the beam loses
    double qsca;   // scattering
    double qabs;   // absorption, never negative; exactly 0 where k = 0
    double qback;  // radar backscattering: 4 pi times the cross-section per solid angle at 180 degrees
    double g;      // mean cosine of the scattering angle, weighted by the scattered light
};

// The coefficients of the series; element i belongs to n = i + 1.
struct MieSeries {
    double x;                             // size parameter 2 pi r / wavelength
    double qabs;                          // summed where it is not the difference of nearly equal numbers
    std::vector<std::complex<double>> a;  // electric multipoles
    std::vector<std::complex<double>> b;  // magnetic multipoles
};

// Terms after which nothing of double precision is left. [Wiscombe1980, eq. 1]
std::size_t mie_term_count(double x);

// For 1e-30 <= x <= 1e5. Stable for any absorption and down to the smallest x: logarithmic derivatives are found by downward
// recurrence, Riccati-Bessel functions upward while they oscillate and by downward ratios beyond. Cost: max(x, |n - ik| x) terms.
MieSeries mie_series(double x, RefractiveIndex index);

MieEfficiencies mie_efficiencies(const MieSeries& series);
MieEfficiencies mie_efficiencies(double x, RefractiveIndex index);

// The amplitudes of the scattered field: s1 across the plane of scattering, s2 in it.
struct MieAmplitudes {
    std::complex<double> s1;
    std::complex<double> s2;
};

// At the cosine `nu` of the scattering angle, -1 to 1.
MieAmplitudes mie_amplitudes(const MieSeries& series, double nu);

// The element M11 of the Mueller matrix (|S1|^2 + |S2|^2) / 2: the cross-section per solid angle is (wavelength / 2 pi)^2 M11,
// and M11 / (pi x^2 qsca) is the phase function.
double mueller_11(const MieAmplitudes& amplitudes);

// Degree of linear polarisation of scattered natural light, -M12 / M11: 1 across the plane of scattering, -1 in it.
double polarisation(const MieAmplitudes& amplitudes);

}  // namespace airlight
