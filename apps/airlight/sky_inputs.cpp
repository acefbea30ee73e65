#include "sky_inputs.h"

#include <fmt/format.h>

#include "atmosphere/validate.h"
#include "sky/reference_sky.h"
#include "sky/table_sky.h"
#include "transport/table_cache.h"

namespace airlight::cli {

namespace {

Result<std::unique_ptr<Sky>> table_sky(const SkyInputs& inputs, const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths,
                                       const Progress& progress) {
    BakeSettings wanted{.sizes = {}, .orders = inputs.orders};
    if (!inputs.sizes.empty()) {
        const Result<TableSizes> sizes = parse_table_sizes(inputs.sizes);
        if (!sizes) return at("--sizes", sizes.error());
        wanted.sizes = *sizes;
    }
    const Result<BakeSettings> settings = validated(wanted);
    if (!settings) return at("--orders", settings.error());
    CacheSettings cache;
    if (!inputs.cache.empty()) cache.folder = inputs.cache;
    cache.warn = [](const Error& warning) { fmt::print(stderr, "warning: {}\n", warning.message()); };
    Result<Tables> tables = cached_tables(atmosphere, std::move(wavelengths), *settings, cache, progress);
    if (!tables) return tables.error();
    return std::unique_ptr<Sky>(std::make_unique<TableSky>(std::make_shared<const Tables>(std::move(*tables))));
}

Result<std::unique_ptr<Sky>> reference_sky(const SkyInputs& inputs, const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths,
                                           const Progress& progress) {
    if (inputs.paths < 1) return Error{"--paths", fmt::format("{} is out of range: it must be 1 or more", inputs.paths), ""};
    Result<Reference> reference = Reference::of(atmosphere, std::move(wavelengths));
    if (!reference) return reference.error();
    const ReferenceSettings settings{.paths = inputs.paths, .seed = inputs.seed};
    return std::unique_ptr<Sky>(std::make_unique<ReferenceSky>(std::move(*reference), atmosphere.bottom_radius, settings, progress));
}

}  // namespace

void add_sky_inputs(CLI::App& app, SkyInputs& inputs) {
    add_air_inputs(app, inputs.air)->required();
    app.add_option("--wavelengths", inputs.wavelengths, "in nm: 450,550,650 or 360:830:16 (first, last, count)")
        ->option_text("<grid>")
        ->capture_default_str();
    app.add_option("--model", inputs.model, "tables (fast) or reference (Monte Carlo, with standard errors)")
        ->option_text("<name>")
        ->capture_default_str();
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
    if (inputs.model != "tables" && inputs.model != "reference") {
        const std::string near = nearest_word(inputs.model, "tables reference");
        return Error{"--model", fmt::format("\"{}\" is no model: it must be tables or reference", inputs.model),
                     near.empty() ? "" : fmt::format("Did you mean {}?", near)};
    }
    Result<std::unique_ptr<Sky>> sky = inputs.model == "tables" ? table_sky(inputs, air->atmosphere, wavelengths, progress)
                                                                : reference_sky(inputs, air->atmosphere, wavelengths, progress);
    if (!sky) return sky.error();
    return AskedSky{std::move(air->atmosphere), std::move(air->decisions), std::move(*grid), std::move(*sky)};
}

}  // namespace airlight::cli
