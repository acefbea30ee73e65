#include "models/turbidity.h"

#include <fmt/format.h>

#include <variant>

#include "atmosphere/validate.h"

namespace airlight {

Result<double> turbidity(const Atmosphere& atmosphere) {
    if (const Result<Done> covered = covers(atmosphere, 550.0 * nm, 550.0 * nm); !covered) return covered.error();
    double molecules = 0.0, aerosol = 0.0;
    for (const Constituent& c : atmosphere.constituents) {
        const InverseLength scattering = c.scattering.at(550.0 * nm);
        if (!(scattering > 0.0 * per_m)) continue;
        const double depth = ((scattering + c.absorption.at(550.0 * nm)) * column_depth(c.profile, atmosphere.top_altitude)).value;
        (std::holds_alternative<RayleighPhase>(c.phase) ? molecules : aerosol) += depth;
    }
    if (!(molecules > 0.0))
        return Error{atmosphere.name, "has no molecules that scatter at 550 nm, so it has no turbidity",
                     "Give the turbidity itself, or take a model that does not need it."};
    return 1.0 + aerosol / molecules;
}

Result<double> turbidity_in(double lowest, double highest, std::string_view model, const Atmosphere& atmosphere,
                            const ModelOptions& options) {
    const Result<double> t = options.turbidity ? Result<double>(*options.turbidity) : turbidity(atmosphere);
    if (!t) return t.error();
    if (!(*t >= lowest && *t <= highest))
        return Error{std::string(model),
                     fmt::format("does not answer a turbidity of {:.3g}{}: its range is {:g} to {:g}", *t,
                                 options.turbidity ? "" : fmt::format(", which is that of {}", atmosphere.name), lowest, highest),
                     ""};
    return *t;
}

}  // namespace airlight
