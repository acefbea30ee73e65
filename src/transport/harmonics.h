// Real spherical harmonics that are even in the azimuth: radiance is, about the sun's vertical plane.
// Multiplying a function's coefficients by the Legendre moments of a phase function scatters it (Funk and Hecke).
// Theory: docs/theory.md, section 5.3. Uses nothing.
#pragma once

#include <vector>

namespace airlight {

// Coefficients are stored order by order: all degrees l = 0 .. degree of azimuthal order 0, then l = 1 .. degree of order 1, ...
struct HarmonicLayout {
    int degree;
    int count() const { return (degree + 1) * (degree + 2) / 2; }
    int index(int l, int order) const { return order * (2 * degree + 3 - order) / 2 + (l - order); }
};

// The normalised associated Legendre functions at mu, such that the harmonics value[index(l, k)] cos(k phi) are
// orthonormal on the sphere: [layout.count()].
std::vector<float> legendre_values(const HarmonicLayout& layout, double mu);

}  // namespace airlight
