// `airlight mie`: what one sphere takes from a beam of light and where it scatters it.

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <optional>

#include "command.h"
#include "optics/mie.h"
#include "units/units.h"

namespace airlight::cli {

namespace {

struct MieOptions {
    double radius_um = 0.0;
    double wavelength_nm = 0.0;
    double n = 0.0;
    double k = 0.0;
    std::optional<int> angles;
};

constexpr double greatest_size = 1e5;
constexpr double smallest_size = 1e-30;

double size_parameter(const MieOptions& given) { return 2.0 * pi * given.radius_um * 1000.0 / given.wavelength_nm; }

std::optional<Error> out_of_range(const MieOptions& given) {
    const auto error = [](const char* option, double value, const char* rule) {
        return Error{option, fmt::format("{} is out of range: it must be {}", value, rule), ""};
    };
    const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
    if (!positive(given.radius_um)) return error("--radius-um", given.radius_um, "above 0");
    if (!positive(given.wavelength_nm)) return error("--wavelength-nm", given.wavelength_nm, "above 0");
    if (!(given.n > 0.0 && given.n <= 100.0)) return error("--n", given.n, "above 0 and at most 100");
    if (!(given.k >= 0.0 && given.k <= 100.0)) return error("--k", given.k, "from 0 to 100");
    if (given.angles && (*given.angles < 2 || *given.angles > 1000000)) return error("--angles", *given.angles, "from 2 to 1000000");
    const double x = size_parameter(given);
    if (!(x >= smallest_size && x <= greatest_size))
        return Error{"--radius-um",
                     fmt::format("the size parameter 2 pi r / wavelength is {:.6g}, out of range: it must be from {} to {}", x,
                                 smallest_size, greatest_size),
                     "Above it use geometric optics."};
    return std::nullopt;
}

void print_efficiencies(const MieSeries& series) {
    const MieEfficiencies e = mie_efficiencies(series);
    fmt::print("qext,qsca,qabs,g\n{:.7g},{:.7g},{:.7g},{:.7g}\n", e.qext, e.qsca, e.qabs, e.g);
}

void print_angles(const MieSeries& series, int count) {
    const double sphere = pi * series.x * series.x * mie_efficiencies(series).qsca;
    fmt::print("angle_deg,m11,polarisation,phase_per_sr\n");
    for (int i = 0; i < count; ++i) {
        const double angle_deg = 180.0 * i / (count - 1);
        const MieAmplitudes amplitudes = mie_amplitudes(series, std::cos(angle_deg * deg));
        const double m11 = mueller_11(amplitudes);
        fmt::print("{:.7g},{:.7g},{:.6f},{:.7g}\n", angle_deg, m11, polarisation(amplitudes), sphere > 0.0 ? m11 / sphere : 0.0);
    }
}

Result<Done> run(const MieOptions& given) {
    if (const std::optional<Error> error = out_of_range(given)) return *error;
    const MieSeries series = mie_series(size_parameter(given), {given.n, given.k});
    given.angles ? print_angles(series, *given.angles) : print_efficiencies(series);
    return Done{};
}

}  // namespace

Command mie_command(CLI::App& airlight) {
    const auto given = std::make_shared<MieOptions>();
    CLI::App* mie = airlight.add_subcommand("mie", "Print what a sphere takes from a beam of light, and where it scatters it.");
    mie->add_option("--radius-um", given->radius_um, "radius of the sphere")->option_text("<um>")->required();
    mie->add_option("--wavelength-nm", given->wavelength_nm, "of the light, in what surrounds the sphere")->option_text("<nm>")->required();
    mie->add_option("--n", given->n, "real part of its refractive index n - ik, above 0")->option_text("<n>")->required();
    mie->add_option("--k", given->k, "imaginary part; 0 does not absorb")->option_text("<k>")->capture_default_str();
    mie->add_option("--angles", given->angles, "print so many scattering angles, 0 to 180, instead")->option_text("<count>");
    mie->footer(
        help_footer("CSV, one row: qext, qsca, qabs (cross-sections over pi r^2), g (mean cosine of the scattering angle);\n"
                    "        with --angles, a row an angle: angle_deg, m11 (the Mueller element (|S1|^2 + |S2|^2) / 2),\n"
                    "        polarisation (degree, linear, of scattered natural light), phase_per_sr",
                    "airlight mie --radius-um 1 --wavelength-nm 500 --n 1.5 --k 0"));
    return {mie, [given] { return run(*given); }};
}

}  // namespace airlight::cli
