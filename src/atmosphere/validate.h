// The rules that a description keeps before light transport may rely on it.
// Theory: docs/theory.md, section 2; the rules in words: docs/atmosphere-file.md. Uses the description only.
#pragma once

#include <optional>
#include <string>

#include "atmosphere/atmosphere.h"
#include "core/result.h"

namespace airlight {

inline constexpr std::size_t max_constituents = 8;
inline constexpr Length min_bottom_radius = 100.0 * km;
inline constexpr Length max_bottom_radius = 1e9 * km;  // so large a sphere is a plane along any path in the air

// The first rule that a description breaks, by the key under which a file gives it:
// "planet.radius", "ground.albedo", "sun.angular_radius", "<constituent's name>.profile.scale_height".
struct BrokenRule {
    std::string key;
    std::string value;   // as a file would write it
    std::string rule;    // "it must be above 0 m"
    std::string remedy;  // one sentence, or empty

    Error error() const;
};

std::optional<BrokenRule> broken_rule(const Atmosphere& atmosphere);

// The same for a part alone, by its own keys: "scale_height", "g".
std::optional<BrokenRule> broken_rule(const DensityProfile& profile);
std::optional<BrokenRule> broken_rule(const PhaseFunction& phase);

// The same atmosphere, or the first rule that it breaks.
Result<Atmosphere> validated(Atmosphere atmosphere);

// Whether every spectrum and phase function has data over all of [first, last].
// Fails with the name of the one that has not, and with the wavelengths that it has.
Result<Done> covers(const Atmosphere& atmosphere, Wavelength first, Wavelength last);

}  // namespace airlight
