#include "optics/phase_function.h"

#include <algorithm>
#include <cmath>

#include "physics/f64.h"

namespace airlight {

namespace {

template <class... F>
struct Overloaded : F... {
    using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;

InverseSolidAngle from_text(f64::InverseSolidAngle phase) { return InverseSolidAngle::of(phase.value); }

// Index i and weight t such that x lies at (1 - t) of sample i and t of sample i + 1; clamped at the ends.
template <class T>
std::pair<std::size_t, double> bracket(const std::vector<T>& samples, T x) {
    if (samples.size() < 2 || !(samples.front() < x)) return {0, 0.0};
    const std::size_t last = samples.size() - 1;
    if (!(x < samples[last])) return {last - 1, 1.0};
    const auto above = std::upper_bound(samples.begin(), samples.end(), x);
    const std::size_t i = static_cast<std::size_t>(above - samples.begin()) - 1;
    return {i, (x - samples[i]) / (samples[i + 1] - samples[i])};
}

double tabulated_value(const TabulatedPhase& table, double nu, Wavelength wavelength) {
    const auto [a, u] = bracket(table.angles, std::acos(std::clamp(nu, -1.0, 1.0)));
    const auto row_value = [&, a = a, u = u](std::size_t w) { return table.values[w][a] * (1.0 - u) + table.values[w][a + 1] * u; };
    if (table.wavelengths.size() == 1) return row_value(0);
    std::size_t w = 0;
    while (w + 2 < table.wavelengths.size() && table.wavelengths[w + 1] < wavelength) ++w;
    const double t = std::clamp((wavelength - table.wavelengths[w]) / (table.wavelengths[w + 1] - table.wavelengths[w]), Number(0.0), Number(1.0)).value;
    return row_value(w) * (1.0 - t) + row_value(w + 1) * t;
}

}  // namespace

InverseSolidAngle phase_value(const PhaseFunction& phase, double nu, Wavelength wavelength) {
    return std::visit(
        Overloaded{
            [&](const IsotropicPhase&) { return 1.0 / (4.0 * pi) * per_sr; },
            [&](const RayleighPhase& p) { return from_text(f64::depolarised_rayleigh_phase(p.depolarisation / (2.0 - p.depolarisation), nu)); },
            [&](const HenyeyGreensteinPhase& p) { return from_text(f64::henyey_greenstein_phase(p.g.at(wavelength), nu)); },
            [&](const CornetteShanksPhase& p) { return from_text(f64::cornette_shanks_phase(p.g.at(wavelength), nu)); },
            [&](const TabulatedPhase& p) { return tabulated_value(p, nu, wavelength) * per_sr; },
        },
        phase);
}

}  // namespace airlight
