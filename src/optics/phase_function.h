// How a constituent of the air redistributes light over directions.
// Theory: docs/theory.md, section 3.1. Uses physics (the analytic laws) and curves; knows nothing of densities.
#pragma once

#include <variant>
#include <vector>

#include "units/curve.h"
#include "units/units.h"

namespace airlight {

struct IsotropicPhase {
    friend bool operator==(const IsotropicPhase&, const IsotropicPhase&) = default;
};

// Molecules; depolarisation is the ratio for natural light (0: Rayleigh's own; air about 0.0279).
struct RayleighPhase {
    double depolarisation = 0.0;
    friend bool operator==(const RayleighPhase&, const RayleighPhase&) = default;
};

// g: mean cosine, in (-1, 1), by wavelength.
struct HenyeyGreensteinPhase {
    SpectrumOf<Number> g = SpectrumOf<Number>::constant(0.0);
    friend bool operator==(const HenyeyGreensteinPhase&, const HenyeyGreensteinPhase&) = default;
};

// g: the parameter of Cornette and Shanks' form, in (-1, 1), by wavelength.
struct CornetteShanksPhase {
    SpectrumOf<Number> g = SpectrumOf<Number>::constant(0.0);
    friend bool operator==(const CornetteShanksPhase&, const CornetteShanksPhase&) = default;
};

// Values at scattering angles, linear in the angle between them and linear in wavelength.
//   angles       [A] scattering angles in radians, 0 (forward) first, pi last, strictly increasing
//   wavelengths  [W] strictly increasing
//   values       [W][A] in 1/sr, >= 0; each row integrates to one over the sphere (tabulated_phase() makes it so)
struct TabulatedPhase {
    std::vector<double> angles;
    std::vector<Wavelength> wavelengths;
    std::vector<std::vector<double>> values;
    friend bool operator==(const TabulatedPhase&, const TabulatedPhase&) = default;
};

using PhaseFunction = std::variant<IsotropicPhase, RayleighPhase, HenyeyGreensteinPhase, CornetteShanksPhase, TabulatedPhase>;

// The phase function at the cosine `nu` of the scattering angle, -1 <= nu <= 1 (1: forward).
InverseSolidAngle phase_value(const PhaseFunction& phase, double nu, Wavelength wavelength);

// A tabulated phase function, each row normalised; fails if shapes or orders are wrong, a value is negative or not finite, or a row is zero.
Result<PhaseFunction> tabulated_phase(TabulatedPhase table);

// Whether the phase function has data at each wavelength of [first, last].
bool covers(const PhaseFunction& phase, Wavelength first, Wavelength last);

// The mean cosine of the scattering angle, -1 to 1.
double asymmetry(const PhaseFunction& phase, Wavelength wavelength);

}  // namespace airlight
