// `airlight probe`: the spectral radiance seen along one view direction.

#include <fmt/format.h>

#include <memory>

#include "command.h"
#include "interrupt.h"
#include "sky_inputs.h"

namespace airlight::cli {

namespace {

struct ProbeOptions {
    SkyInputs inputs;
    double zenith_deg = 0.0;
    double azimuth_deg = 0.0;
    double sun_deg = 45.0;
    double altitude_m = 0.0;
};

Result<Done> run(const ProbeOptions& given) {
    const Interrupt interrupt;
    const View view{given.altitude_m * m, given.zenith_deg * deg, given.sun_deg * deg, given.azimuth_deg * deg};
    if (const Result<Done> ok = check_view(view.altitude, view.view_zenith, view.sun_zenith, view.relative_azimuth); !ok) return ok.error();
    ProgressLine line(given.inputs.quiet);
    const Result<AskedSky> asked = asked_sky(given.inputs, line.progress(interrupt.token()));
    if (!asked) return asked.error();
    const Result<RadianceEstimate> seen = asked->sky->radiance(view);
    if (!seen) return seen.error();
    fmt::print("wavelength_nm,radiance_W_m-2_sr-1_nm-1,standard_error\n");
    for (int i = 0; i < asked->wavelengths.size(); ++i) {
        const auto k = static_cast<std::size_t>(i);
        fmt::print("{:g},{:.6e},{:.1e}\n", asked->wavelengths[i].in(nm), seen->radiance_W_m2_sr_nm[k], seen->standard_error[k]);
    }
    return Done{};
}

}  // namespace

Command probe_command(CLI::App& airlight) {
    const auto given = std::make_shared<ProbeOptions>();
    CLI::App* probe = airlight.add_subcommand("probe", "Print the spectral radiance seen along one view direction.");
    probe->add_option("--zenith", given->zenith_deg, "zenith angle of the view, 0 (straight up) to 180")->option_text("<deg>")->required();
    probe->add_option("--azimuth", given->azimuth_deg, "azimuth of the view from the sun's")->option_text("<deg>")->capture_default_str();
    probe->add_option("--sun", given->sun_deg, "zenith angle of the sun, 0 to 180")->option_text("<deg>")->capture_default_str();
    probe->add_option("--altitude-m", given->altitude_m, "height of the eye above the ground, 0 or more; space is fine")
        ->option_text("<m>")
        ->capture_default_str();
    add_sky_inputs(*probe, given->inputs);
    probe->footer(
        help_footer("CSV, one row a wavelength: wavelength_nm, radiance_W_m-2_sr-1_nm-1, standard_error (0 for tables).\n"
                    "        The sun's disk is not part of the radiance.",
                    "airlight probe earth-clear --zenith 80 --sun 60 --sizes 16x8x16x8 --orders 3 --cache tables"));
    return {probe, [given] { return run(*given); }};
}

}  // namespace airlight::cli
