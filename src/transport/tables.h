// The tables of an atmosphere at any number of wavelengths: a function of the description, and read-only.
// Theory: docs/theory.md, section 5. Uses the bake; sky/table_sky.h asks it for light.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/progress.h"
#include "core/result.h"
#include "transport/bake.h"

namespace airlight {

class Tables {
public:
    // One pack of at most sixteen wavelengths: the description in the inner loops' form, and what was baked from it.
    struct Pack {
        AirOptics optics;
        PackAir air;
        PackTables tables;
    };

    // Puts packs together that were baked or read; as many as packs(wavelengths).
    Tables(Atmosphere atmosphere, std::vector<Wavelength> wavelengths, BakeSettings settings, std::vector<PackTables> packs);

    const Atmosphere& atmosphere() const { return atmosphere_; }
    std::span<const Wavelength> wavelengths() const { return wavelengths_; }
    const BakeSettings& settings() const { return settings_; }
    std::span<const Pack> packs() const { return packs_; }

private:
    Atmosphere atmosphere_;
    std::vector<Wavelength> wavelengths_;
    BakeSettings settings_;
    std::vector<Pack> packs_;
};

// Bakes every pack, on all cores. Fails if a wavelength is not covered by the atmosphere, or if `progress` asks to stop.
//   wavelengths  1 or more, strictly increasing
Result<Tables> bake_tables(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const BakeSettings& settings,
                           const Progress& progress);

}  // namespace airlight
