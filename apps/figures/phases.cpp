// Phase functions by the scattering angle. [Nielsen2003, fig. 2.3 to 2.5 and 5.1; Sperlhofer2011, fig. 2-1 and 2-2]

#include <cmath>

#include "atmosphere/presets.h"
#include "figure.h"
#include "physics/f64.h"
#include "physics/models/f64.h"

namespace airlight::figures {

namespace {

constexpr Wavelength green = 550.0 * nm;

// The aerosol of clean land, whose phase function is Mie's, tabulated.
Result<PhaseFunction> aerosol_phase() {
    const Result<Atmosphere> air = preset("earth-clear");
    if (!air) return air.error();
    for (const Constituent& c : air->constituents)
        if (std::holds_alternative<TabulatedPhase>(c.phase)) return c.phase;
    return Error{"earth-clear", "has no aerosol with a tabulated phase function", ""};
}

// The g with which Cornette and Shanks' function has a mean cosine: theirs is not g.
double cornette_shanks_parameter(double mean_cosine) {
    double low = 0.0, high = 0.999;
    while (high - low > 1e-9) {
        const double g = 0.5 * (low + high);
        (asymmetry(CornetteShanksPhase{SpectrumOf<Number>::constant(g)}, green) < mean_cosine ? low : high) = g;
    }
    return 0.5 * (low + high);
}

}  // namespace

Result<Table> phase_functions(const Settings& settings) {
    const Result<PhaseFunction> mie = aerosol_phase();
    if (!mie) return mie.error();
    const double mean_cosine = asymmetry(*mie, green), g = cornette_shanks_parameter(mean_cosine);
    Table table{{"angle_deg", "rayleigh", "softened_rayleigh", "henyey_greenstein_0_2", "henyey_greenstein", "cornette_shanks", "mie",
                 "mean_cosine", "cornette_shanks_g"},
                {}};
    const int points = 2 * (settings.points - 1) + 1;
    for (int i = 0; i < points; ++i) {
        const double angle = pi * i / (points - 1);
        const f64::Number nu = std::cos(angle);
        table.rows.push_back(
            {{},
             {angle / deg, f64::rayleigh_phase(nu).value, f64::softened_rayleigh_phase(nu).value,
              f64::henyey_greenstein_phase(f64::Number(0.2), nu).value, f64::henyey_greenstein_phase(f64::Number(mean_cosine), nu).value,
              f64::cornette_shanks_phase(f64::Number(g), nu).value, phase_value(*mie, nu.value, green).value, mean_cosine, g}});
    }
    return table;
}

}  // namespace airlight::figures
