// What commands that draw air ask about its tables.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "frame_of_scene.h"
#include "transport/bake.h"

namespace airlight::cli {

struct TableOptions {
    std::string sizes = table_sizes_text({});
    int orders = BakeSettings{}.orders;
    std::string cache;
};

// Declares the options that fill `options`.
void add_table_options(CLI::App& app, TableOptions& options);

// Fails for sizes and orders that cannot be. What the cache warns of goes to standard error.
Result<TableWishes> table_wishes_of(const TableOptions& given);

}  // namespace airlight::cli
