// tables: single scattering integrated along the ray, all higher orders from the table of their source (sky/table_sky.h).
//   parameters   sizes of the tables, orders computed before the series is closed, folder of the cache
//   leaves out   polarisation, refraction; dark with the sun more than 30 degrees below the horizon
#include "models/list.h"
#include "sky/table_sky.h"

namespace airlight {

namespace {

Result<std::unique_ptr<Sky>> make(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions& options) {
    Result<Tables> tables = cached_tables(atmosphere, std::move(wavelengths), options.bake, options.cache, options.progress);
    if (!tables) return tables.error();
    return std::unique_ptr<Sky>(std::make_unique<TableSky>(std::make_shared<const Tables>(std::move(*tables))));
}

}  // namespace

Model tables_model() {
    return {{.key = "tables",
             .paper = "",
             .scattering = "single exact; higher orders from tables",
             .approach = "single scattering integrated along the ray, higher orders from the table of their source",
             .precomputation = "seconds a pack of 16 wavelengths",
             .memory = "66 MiB a pack at the default sizes",
             .highest_eye = anywhere,
             .aerial_perspective = true},
            make};
}

}  // namespace airlight
