// Nishita's spheres at equal steps of density, and the table of sunlight that he sums along them. [NishitaEtAl1993, sec. 3]
#pragma once

#include <vector>

#include "models/two_constituents.h"

namespace airlight {

// Optical depths towards the sun where each sphere meets each cylinder: on the sun's side of the planet's waist and beyond it.
class DensitySpheres {
public:
    static constexpr int spheres = 64;
    // Half of them within the planet, even in the sun's zenith angle on the ground; half touch a sphere.
    static constexpr int cylinders = 2 * spheres - 1;

    explicit DensitySpheres(const TwoConstituents& air);

    f64::ScatteredLight light(const f64::AirRay& ray) const;
    f64::Spectrum sunlight(f64::Length altitude, double mu_s) const;

private:
    Table2D<f64::Spectrum> near() const { return {near_, spheres, cylinders}; }
    Table2D<f64::Spectrum> beyond() const { return {beyond_, spheres, spheres}; }

    f64::ExponentialAir air_;
    std::vector<f64::Spectrum> near_;    // [cylinders][spheres]
    std::vector<f64::Spectrum> beyond_;  // [spheres, which cylinders touch][spheres]
};

}  // namespace airlight
