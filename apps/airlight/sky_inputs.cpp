#include "sky_inputs.h"

#include <fmt/format.h>

#include "atmosphere/validate.h"
#include "models/model.h"

namespace airlight::cli {

namespace {

// Everything that was said of the model.
Result<ModelOptions> model_options(const SkyInputs& inputs, const Progress& progress) {
    ModelOptions options;
    options.turbidity = inputs.turbidity;
    options.data = inputs.data;
    options.cie_type = inputs.cie_type;
    options.clearness = inputs.clearness;
    options.brightness = inputs.brightness;
    options.variant = inputs.variant;
    options.bake.orders = inputs.orders;
    options.reference = {.paths = inputs.paths, .seed = inputs.seed};
    options.progress = progress;
    if (!inputs.sizes.empty()) {
        const Result<TableSizes> sizes = parse_table_sizes(inputs.sizes);
        if (!sizes) return at("--sizes", sizes.error());
        options.bake.sizes = *sizes;
    }
    if (const Result<BakeSettings> ok = validated(options.bake); !ok) return at("--orders", ok.error());
    if (inputs.paths < 1) return Error{"--paths", fmt::format("{} is out of range: it must be 1 or more", inputs.paths), ""};
    if (!inputs.cache.empty()) options.cache.folder = inputs.cache;
    options.cache.warn = [](const Error& warning) { fmt::print(stderr, "warning: {}\n", warning.message()); };
    return options;
}

}  // namespace

void add_sky_inputs(CLI::App& app, SkyInputs& inputs) {
    add_air_inputs(app, inputs.air)->required();
    app.add_option("--wavelengths", inputs.wavelengths, "in nm: 450,550,650 or 360:830:16 (first, last, count)")
        ->option_text("<grid>")
        ->capture_default_str();
    app.add_option("--model", inputs.model, "tables, reference (Monte Carlo, with standard errors) or another of `airlight models`")
        ->option_text("<name>")
        ->capture_default_str();
    app.add_option("--turbidity", inputs.turbidity, "models of turbidity: instead of that of the atmosphere")->option_text("<T>");
    app.add_option("--data", inputs.data, "models that read a data set: its file")->option_text("<file>");
    app.add_option("--cie-type", inputs.cie_type, "cie2003: which of the 15 standard skies, 1 (overcast) to 15")
        ->option_text("<n>")
        ->capture_default_str();
    app.add_option("--clearness", inputs.clearness, "perez1993: 1 (no beam) and more, instead of that of the atmosphere")
        ->option_text("<x>");
    app.add_option("--brightness", inputs.brightness, "perez1993: 0 to 1, instead of that of the atmosphere")->option_text("<x>");
    app.add_option("--variant", inputs.variant, "models with several forms: which one")->option_text("<name>");
    app.add_option("--orders", inputs.orders, "tables: orders of scattering computed, the rest extrapolated")
        ->option_text("<n>")
        ->capture_default_str();
    app.add_option("--sizes", inputs.sizes, "tables: texels of sun x azimuth x view x altitude (default: 64x16x32x32)")
        ->option_text("<sizes>");
    app.add_option("--paths", inputs.paths, "reference: paths in each direction")->option_text("<n>")->capture_default_str();
    app.add_option("--seed", inputs.seed, "reference: the same seed gives the same digits")->option_text("<n>")->capture_default_str();
    app.add_option("--cache", inputs.cache, "where tables are kept (default: $XDG_CACHE_HOME/airlight or ~/.cache/airlight)")
        ->option_text("<folder>");
    app.add_flag("--quiet", inputs.quiet, "no progress on standard error");
}

Result<AskedSky> asked_sky(const SkyInputs& inputs, const Progress& progress) {
    Result<AskedAir> air = asked_air(inputs.air);
    if (!air) return air.error();
    Result<WavelengthGrid> grid = parse_wavelength_grid(inputs.wavelengths);
    if (!grid) return at("--wavelengths", grid.error());
    if (const Result<Done> covered = covers(air->atmosphere, grid->first(), grid->last()); !covered)
        return at(inputs.air.atmosphere, covered.error());
    const std::vector<Wavelength> wavelengths(grid->begin(), grid->end());
    if (!find_model(inputs.model)) return at("--model", make_sky(inputs.model, air->atmosphere, wavelengths).error());
    const Result<ModelOptions> options = model_options(inputs, progress);
    if (!options) return options.error();
    Result<std::unique_ptr<Sky>> sky = make_sky(inputs.model, air->atmosphere, wavelengths, *options);
    if (!sky) return sky.error();
    return AskedSky{std::move(air->atmosphere), std::move(air->decisions), std::move(*grid), std::move(*sky)};
}

}  // namespace airlight::cli
