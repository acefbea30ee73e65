// The phase functions of an atmosphere at the wavelengths of a pack, sampled for inner loops, and what they make of light that was
// gathered along a ray without them. Uses transport (optics); knows nothing of where the light is from.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "physics/f32.h"
#include "transport/air_optics.h"

namespace airlight {

class PackPhases {
public:
    explicit PackPhases(const AirOptics& optics);

    // The constituents that scatter, in the order of the atmosphere.
    std::span<const std::size_t> parts() const { return parts_; }
    // Values at scattering angles that are even in their root: [sample][i of parts()].
    std::span<const f32::PhaseSpectrum> samples() const { return samples_; }
    // How many of the pack's wavelengths are distinct.
    int wavelength_count() const { return wavelength_count_; }

    // Where a scattering angle lies among the samples.
    struct Place {
        std::size_t low;
        float weight;  // of the next sample
    };
    // Of the cosine `nu` of the scattering angle, -1 <= nu <= 1.
    static Place place(double nu);

    // Adds the light that parts()[i] scattered once: `single` times the phase function is radiance.
    AIRLIGHT_INLINE void add(Place at, std::size_t i, const f32::IrradianceSpectrum& single, f32::RadianceSpectrum& radiance) const {
        const f32::PhaseSpectrum &a = samples_[at.low * parts_.size() + i], &b = samples_[(at.low + 1) * parts_.size() + i];
        for (int w = 0; w < pack_size; ++w) radiance.v[w] += single.v[w] * (a.v[w] + at.weight * (b.v[w] - a.v[w]));
    }

    // Radiance of light along a ray: `multiple` is radiance, `single[p]` one scattering in constituent p.
    template <class Light>
    f32::RadianceSpectrum radiance(const Light& light, double nu) const {
        f32::RadianceSpectrum sum = light.multiple;
        const Place at = place(nu);
        for (std::size_t i = 0; i < parts_.size(); ++i) add(at, i, light.single[parts_[i]], sum);
        return sum;
    }

private:
    std::vector<std::size_t> parts_;
    int wavelength_count_;
    std::vector<f32::PhaseSpectrum> samples_;  // dense where the phase function peaks
};

// Shared by a sky and its domes.
using PhasesOfPacks = std::vector<std::shared_ptr<const PackPhases>>;

}  // namespace airlight
