// The description of a planet's air, its ground and its sun: everything that light transport needs, and nothing derived.
// Immutable once validated. Theory: docs/theory.md, sections 2 and 3; the file form: docs/atmosphere-file.md.
#pragma once

#include <string>
#include <vector>

#include "atmosphere/density_profile.h"
#include "optics/phase_function.h"
#include "units/curve.h"
#include "units/units.h"

namespace airlight {

// One kind of particle: its coefficient at altitude h is its relative density there times these.
struct Constituent {
    std::string name;
    DensityProfile profile;
    SpectrumOf<InverseLength> scattering = SpectrumOf<InverseLength>::constant(0.0 * per_m);
    SpectrumOf<InverseLength> absorption = SpectrumOf<InverseLength>::constant(0.0 * per_m);
    PhaseFunction phase = IsotropicPhase{};  // of no meaning where scattering is zero
    friend bool operator==(const Constituent&, const Constituent&) = default;
};

// A disk at infinity. Limb darkening: I(mu) / I(1) = 1 - sum over k of u_k (1 - mu)^k, k = 1, 2; 0 is a uniform disk.
struct Sun {
    SpectrumOf<SpectralIrradiance> irradiance =
        SpectrumOf<SpectralIrradiance>::constant(1.0 * W_per_m2_nm);  // on a plane facing it, above the air
    double angular_radius = 0.0;                                      // radians; 0 is a point
    SpectrumOf<Number> limb_darkening_1 = SpectrumOf<Number>::constant(0.0);
    SpectrumOf<Number> limb_darkening_2 = SpectrumOf<Number>::constant(0.0);
    friend bool operator==(const Sun&, const Sun&) = default;
};

struct Atmosphere {
    std::string name;
    Length bottom_radius;  // of the ground sphere
    Length top_altitude;   // above it there is no air
    std::vector<Constituent> constituents;
    SpectrumOf<Number> ground_albedo = SpectrumOf<Number>::constant(0.0);  // Lambertian, 0 to 1
    Sun sun;
    friend bool operator==(const Atmosphere&, const Atmosphere&) = default;
};

}  // namespace airlight
