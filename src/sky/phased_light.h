// Radiance from light that was gathered along a ray without its phase functions.
// Uses transport (optics); knows nothing of where the light is from.
#pragma once

#include "physics/f32.h"
#include "transport/air_optics.h"

namespace airlight {

// Radiance in a direction whose cosine to the sun is `nu`, at the wavelengths of a pack.
//   light  `multiple` is radiance; `single[p]` is one scattering in constituent p, which its phase function makes radiance
template <class Light>
AIRLIGHT_INLINE f32::RadianceSpectrum with_phases(const AirOptics& optics, const Light& light, double nu) {
    f32::RadianceSpectrum radiance = light.multiple;
    for (std::size_t p = 0; p < optics.parts.size(); ++p) {
        if (!optics.parts[p].scatters) continue;
        const f64::PhaseSpectrum phase = optics.parts[p].phase.at(nu);
        for (int w = 0; w < pack_size; ++w) radiance.v[w] += light.single[p].v[w] * static_cast<float>(phase.v[w]);
    }
    return radiance;
}

}  // namespace airlight
