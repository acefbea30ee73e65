// Spheres of many sizes: lognormal distributions, and the light that their mean particle takes and scatters.
// Theory: docs/theory.md, section 3.4. Uses Mie's series; knows nothing of what the particles are.
#pragma once

#include <cstddef>
#include <vector>

#include "optics/mie.h"
#include "optics/mie_angles.h"
#include "units/units.h"

namespace airlight {

// Number of particles by radius: normal in ln r around the mode radius with the deviation ln sigma, cut at both ends.
// The cuts take particles away; the rest is not scaled up, so that a number density counts the uncut distribution.
// This is how OPAC's particle masses and coefficients come out. [HessKoepkeSchult1998, eq. 3d]
struct LognormalSizes {
    Length mode_radius;
    double sigma;  // > 1
    Length radius_min;
    Length radius_max;
};

// Particles in a unit interval of ln r, as a share of all; zero outside the cuts.
double number_per_log_radius(const LognormalSizes& sizes, Length radius);

// What one particle does in the mean over sizes.
struct MeanParticle {
    Area scattering;
    Area absorption;
    double g;                              // mean cosine of the scattering angle
    std::vector<double> scattering_m2_sr;  // [angles] cross-section per solid angle at the angles asked for
};

// Width of a step of ln r. Coefficients come within 5e-4 of their limit, phase functions within 1 %, 3 % towards 180 degrees:
// large spheres that do not absorb have resonances narrower than any step, so that the rest falls slowly.
inline constexpr double default_log_step = 0.01;

// By the midpoint rule in ln r.
//   angles    at least series_terms() terms
//   log_step  > 0; the cost goes with its inverse
MeanParticle mean_particle(const LognormalSizes& sizes, RefractiveIndex index, Wavelength wavelength, const MieAngles& angles,
                           double log_step = default_log_step);

// Terms of Mie's series of the largest sphere that mean_particle() looks at.
std::size_t series_terms(const LognormalSizes& sizes, Wavelength wavelength);

}  // namespace airlight
