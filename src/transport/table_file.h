// Tables, and bakes that are not finished, as files: versioned, keyed by what they were baked from, checked when read.
// The form of the file: docs/table-file.md. Uses the tables and their key; the cache (table_cache.h) decides which file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/result.h"
#include "transport/bake.h"
#include "transport/table_key.h"

namespace airlight {

inline constexpr std::uint32_t table_format_version = 1;

// What tables were baked from, as far as their file must know it.
struct TableOrigin {
    TableKey key;
    std::string name;                     // of the atmosphere, for people
    std::vector<Wavelength> wavelengths;  // 1 to 4096, increasing
    BakeSettings settings;
};

TableOrigin table_origin(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const BakeSettings& settings);

// Tables of every pack of the origin's wavelengths. Written whole or not at all: what stood at `path` stays until then.
Result<Done> write_tables(const std::filesystem::path& path, const TableOrigin& origin, std::span<const PackTables> packs);

// Fails, naming the path and what to do, if the file is absent, truncated, damaged, of another program or version, or of
// another origin; if a value is not finite or is negative. Its bits are those that were written.
Result<std::vector<PackTables>> read_tables(const std::filesystem::path& path, const TableOrigin& origin);

// The state of a bake of one pack (at most sixteen wavelengths), 1 or more and fewer than all of its orders done.
Result<Done> write_bake_state(const std::filesystem::path& path, const TableOrigin& origin, const BakeState& state);
Result<BakeState> read_bake_state(const std::filesystem::path& path, const TableOrigin& origin);

// What the head of a table file says; the sections behind it are not read.
struct TableFileSummary {
    TableKey key;
    std::string name;
    std::vector<Wavelength> wavelengths;
    bool finished = true;
    int orders_done = 0;
    std::uint64_t bytes = 0;
};
Result<TableFileSummary> read_table_summary(const std::filesystem::path& path);

}  // namespace airlight
