#include "table_wishes.h"

#include <fmt/format.h>

namespace airlight::cli {

void add_table_options(CLI::App& app, TableOptions& options) {
    app.add_option("--orders", options.orders, "of the air's tables: orders of scattering computed, the rest extrapolated")
        ->option_text("<n>")
        ->capture_default_str();
    app.add_option("--sizes", options.sizes, "of the air's tables: texels of sun x azimuth x view x altitude, transmittance")
        ->option_text("<sizes>")
        ->capture_default_str();
    app.add_option("--cache", options.cache, "where tables are kept (default: $XDG_CACHE_HOME/airlight or ~/.cache/airlight)")
        ->option_text("<folder>");
}

Result<TableWishes> table_wishes_of(const TableOptions& given) {
    const Result<TableSizes> sizes = parse_table_sizes(given.sizes);
    if (!sizes) return at("--sizes", sizes.error());
    const Result<BakeSettings> bake = validated(BakeSettings{.sizes = *sizes, .orders = given.orders});
    if (!bake) return at("--orders", bake.error());
    TableWishes wishes{*bake, {}, {}};
    if (!given.cache.empty()) wishes.cache.folder = given.cache;
    wishes.cache.warn = [](const Error& warning) { fmt::print(stderr, "warning: {}\n", warning.message()); };
    return wishes;
}

}  // namespace airlight::cli
