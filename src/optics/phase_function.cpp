#include "optics/phase_function.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <string_view>

#include "core/overloaded.h"
#include "physics/f64.h"

namespace airlight {

namespace {

InverseSolidAngle from_text(f64::InverseSolidAngle phase) { return InverseSolidAngle::of(phase.value); }

// Where x lies among samples: at (1 - t) of sample i and t of sample i + 1; clamped at the ends.
struct Bracket {
    std::size_t i;
    double t;
};

double ratio(double a, double b) { return a / b; }
double ratio(Wavelength a, Wavelength b) { return (a / b).value; }

template <class T>
Bracket bracket(const std::vector<T>& samples, T x) {
    assert(samples.size() >= 2);
    const auto above = std::upper_bound(samples.begin() + 1, samples.end() - 1, x);
    const std::size_t i = static_cast<std::size_t>(above - samples.begin()) - 1;
    return {i, std::clamp(ratio(x - samples[i], samples[i + 1] - samples[i]), 0.0, 1.0)};
}

// of_row(w), a property of each wavelength's row, linear between the wavelengths.
template <class OfRow>
double between_rows(const TabulatedPhase& table, Wavelength wavelength, OfRow of_row) {
    if (table.wavelengths.size() == 1) return of_row(std::size_t{0});
    const auto [w, t] = bracket(table.wavelengths, wavelength);
    return of_row(w) * (1.0 - t) + of_row(w + 1) * t;
}

double tabulated_value(const TabulatedPhase& table, double nu, Wavelength wavelength) {
    const Bracket angle = bracket(table.angles, std::acos(std::clamp(nu, -1.0, 1.0)));
    return between_rows(table, wavelength,
                        [&](std::size_t w) { return table.values[w][angle.i] * (1.0 - angle.t) + table.values[w][angle.i + 1] * angle.t; });
}

// The integral over [a, b] of f sin, where f is linear from fa to fb.
// In half widths and midpoints, so that the narrow steps of a forward peak lose no digits.
double sine_integral(double a, double b, double fa, double fb) {
    const double mid = 0.5 * (a + b);
    const double half = 0.5 * (b - a);
    return std::sin(mid) * std::sin(half) * (fa + fb) + std::cos(mid) * (std::sin(half) / half - std::cos(half)) * (fb - fa);
}

// The integral of a row over the sphere.
double sphere_integral(const std::vector<double>& angles, const std::vector<double>& row) {
    double sum = 0.0;
    for (std::size_t a = 0; a + 1 < angles.size(); ++a) sum += sine_integral(angles[a], angles[a + 1], row[a], row[a + 1]);
    return 2.0 * pi * sum;
}

// The integral of a row times the cosine of the angle: sin cos is half the sine of twice the angle.
double cosine_integral(const std::vector<double>& angles, const std::vector<double>& row) {
    double sum = 0.0;
    for (std::size_t a = 0; a + 1 < angles.size(); ++a) sum += sine_integral(2.0 * angles[a], 2.0 * angles[a + 1], row[a], row[a + 1]);
    return 0.5 * pi * sum;
}

// Nothing if the samples strictly increase, else what is wrong with them.
template <class T>
std::optional<Error> disorder(std::string_view name, const std::vector<T>& samples) {
    for (std::size_t i = 1; i < samples.size(); ++i)
        if (!(samples[i - 1] < samples[i]))
            return Error{"", fmt::format("{} {} of a phase function does not lie above the one before it", name, i + 1),
                         "Sort the samples and remove doubles."};
    return std::nullopt;
}

std::optional<Error> wrong_shape(const TabulatedPhase& table) {
    if (table.angles.size() < 2 || table.angles.front() != 0.0 || std::abs(table.angles.back() - pi) > 1e-12)
        return Error{"", "the angles of a phase function must run from 0 to 180 degrees", "Add the missing end."};
    if (std::optional<Error> error = disorder("angle", table.angles)) return error;
    if (table.wavelengths.empty()) return Error{"", "a phase function needs at least one wavelength", ""};
    if (std::optional<Error> error = disorder("wavelength", table.wavelengths)) return error;
    if (table.values.size() != table.wavelengths.size())
        return Error{
            "", fmt::format("a phase function has {} rows of values for {} wavelengths", table.values.size(), table.wavelengths.size()),
            ""};
    return std::nullopt;
}

std::optional<Error> wrong_row(const TabulatedPhase& table, std::size_t w) {
    const auto row_error = [&](std::string_view what) {
        return Error{"", fmt::format("the phase function at {} nm {}", table.wavelengths[w].in(nm), what), ""};
    };
    const std::vector<double>& row = table.values[w];
    if (row.size() != table.angles.size()) return row_error(fmt::format("has {} values for {} angles", row.size(), table.angles.size()));
    for (const double value : row)
        if (!std::isfinite(value) || value < 0.0) return row_error(fmt::format("has the value {}, which is not a number from 0 up", value));
    const double integral = sphere_integral(table.angles, row);
    if (!(integral > 0.0 && std::isfinite(integral))) return row_error("is zero in every direction");
    return std::nullopt;
}

}  // namespace

InverseSolidAngle phase_value(const PhaseFunction& phase, double nu, Wavelength wavelength) {
    return std::visit(Overloaded{
                          [&](const IsotropicPhase&) { return 1.0 / (4.0 * pi) * per_sr; },
                          [&](const RayleighPhase& p) {
                              return from_text(f64::depolarised_rayleigh_phase(p.depolarisation / (2.0 - p.depolarisation), nu));
                          },
                          [&](const HenyeyGreensteinPhase& p) { return from_text(f64::henyey_greenstein_phase(p.g.at(wavelength), nu)); },
                          [&](const CornetteShanksPhase& p) { return from_text(f64::cornette_shanks_phase(p.g.at(wavelength), nu)); },
                          [&](const TabulatedPhase& p) { return tabulated_value(p, nu, wavelength) * per_sr; },
                      },
                      phase);
}

Result<PhaseFunction> tabulated_phase(TabulatedPhase table) {
    if (const std::optional<Error> error = wrong_shape(table)) return *error;
    table.angles.back() = pi;
    for (std::size_t w = 0; w < table.values.size(); ++w) {
        if (const std::optional<Error> error = wrong_row(table, w)) return *error;
        const double integral = sphere_integral(table.angles, table.values[w]);
        for (double& value : table.values[w]) value /= integral;
    }
    return PhaseFunction{std::move(table)};
}

bool covers(const PhaseFunction& phase, Wavelength first, Wavelength last) {
    return std::visit(Overloaded{
                          [](const IsotropicPhase&) { return true; },
                          [](const RayleighPhase&) { return true; },
                          [&](const HenyeyGreensteinPhase& p) { return p.g.covers(first, last); },
                          [&](const CornetteShanksPhase& p) { return p.g.covers(first, last); },
                          [&](const TabulatedPhase& p) {
                              return p.wavelengths.size() == 1 || (p.wavelengths.front() <= first && last <= p.wavelengths.back());
                          },
                      },
                      phase);
}

double asymmetry(const PhaseFunction& phase, Wavelength wavelength) {
    return std::visit(Overloaded{
                          [](const IsotropicPhase&) { return 0.0; },
                          [](const RayleighPhase&) { return 0.0; },
                          [&](const HenyeyGreensteinPhase& p) { return p.g.at(wavelength).value; },
                          [&](const CornetteShanksPhase& p) {
                              // [CornetteShanks1992, eq. 9], from the first three Legendre moments 1, g, g^2, g^3 of Henyey and Greenstein's.
                              const double g = p.g.at(wavelength).value;
                              return 3.0 * g * (4.0 + g * g) / (5.0 * (2.0 + g * g));
                          },
                          [&](const TabulatedPhase& p) {
                              return between_rows(p, wavelength, [&](std::size_t w) { return cosine_integral(p.angles, p.values[w]); });
                          },
                      },
                      phase);
}

}  // namespace airlight
