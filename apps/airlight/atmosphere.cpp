// `airlight atmosphere`: what a description of air holds, under which weather, and the same in full as a file.

#include <fmt/format.h>

#include <memory>

#include "air_inputs.h"
#include "atmosphere/atmosphere_file.h"
#include "atmosphere/coefficients.h"
#include "atmosphere/presets.h"
#include "atmosphere/validate.h"
#include "command.h"
#include "spectrum/wavelength_grid.h"
#include "units/text.h"

namespace airlight::cli {

namespace {

struct AtmosphereOptions {
    AirInputs air;
    bool list = false;
    std::string wavelengths = "450,550,650";
    std::string output;
};

void print_row(const std::string& name, Wavelength w, double depth, double albedo, double g, const std::string& column) {
    fmt::print("{},{},{:.5f},{:.4f},{:.4f},{}\n", name, w.in(nm), depth, albedo, g, column);
}

void print_summary(const AskedAir& d, const WavelengthGrid& grid) {
    const Atmosphere& a = d.atmosphere;
    for (const std::string& line : d.decisions) fmt::print("# {}\n", line);
    fmt::print("# {}: radius {}, air up to {}\n", a.name, length_text(a.bottom_radius), length_text(a.top_altitude));
    fmt::print("constituent,wavelength_nm,optical_depth,single_scattering_albedo,asymmetry,column_depth_km\n");
    for (const Constituent& c : a.constituents)
        for (const Wavelength w : grid)
            print_row(c.name, w, optical_depth(c, a.top_altitude, w).value, single_scattering_albedo(c, w), asymmetry(c.phase, w),
                      fmt::format("{:.3f}", column_depth(c.profile, a.top_altitude).in(km)));
    for (const Wavelength w : grid) {
        double scattered = 0.0;
        double forward = 0.0;
        for (const Constituent& c : a.constituents) {
            const double depth = optical_depth(c, a.top_altitude, w).value * single_scattering_albedo(c, w);
            scattered += depth;
            forward += depth * asymmetry(c.phase, w);
        }
        const double depth = optical_depth(a, w).value;
        print_row("all", w, depth, depth > 0.0 ? scattered / depth : 1.0, scattered > 0.0 ? forward / scattered : 0.0, "");
    }
}

Result<Done> run(const AtmosphereOptions& given) {
    if (given.list) {
        for (const std::string_view name : preset_names()) fmt::print("{}\n", name);
        return Done{};
    }
    const Result<WavelengthGrid> grid = parse_wavelength_grid(given.wavelengths);
    if (!grid) return at("--wavelengths", grid.error());
    if (given.air.atmosphere.empty())
        return Error{"", "no atmosphere is named", "Name a preset or a file; `airlight atmosphere --list` shows the presets."};
    const Result<AskedAir> d = asked_air(given.air);
    if (!d) return d.error();
    if (const auto covered = covers(d->atmosphere, grid->first(), grid->last()); !covered) return at(given.air.atmosphere, covered.error());
    if (!given.output.empty())
        if (const auto written = write_atmosphere(given.output, d->atmosphere, d->decisions); !written) return written.error();
    print_summary(*d, *grid);
    return Done{};
}

}  // namespace

Command atmosphere_command(CLI::App& airlight) {
    const auto given = std::make_shared<AtmosphereOptions>();
    CLI::App* atmosphere = airlight.add_subcommand("atmosphere", "Print what an atmosphere holds, and write it in full as a file.");
    add_air_inputs(*atmosphere, given->air);
    atmosphere->add_flag("--list", given->list, "print the presets' names and stop");
    atmosphere->add_option("--wavelengths", given->wavelengths, "in nm: 450,550,650 or 360:830:16 (first, last, count)")
        ->option_text("<grid>")
        ->capture_default_str();
    atmosphere->add_option("-o,--output", given->output, "write the description, every table in full")->option_text("<file.toml>");
    atmosphere->footer(
        help_footer("lines that begin with # (what the report led to; the planet), then CSV, one row a constituent and wavelength:\n"
                    "        constituent, wavelength_nm, optical_depth (vertical, extinction), single_scattering_albedo, asymmetry (mean\n"
                    "        cosine of the scattering angle), column_depth_km (of a layer of density one that holds as much); last, all",
                    "airlight atmosphere earth-clear --metar \"METAR EDDF 171950Z 05004KT 4000 HZ 22/12 Q1018\" -o hazy.toml"));
    return {atmosphere, [given] { return run(*given); }};
}

}  // namespace airlight::cli
