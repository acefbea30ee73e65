// Tables that are kept between runs: loaded if they are there, continued if they were begun, baked if not.
// Uses table files and the bake. One folder serves any number of programs at once: a file appears in it whole or not at all,
// and what it holds is checked each time it is read.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "core/error.h"
#include "core/progress.h"
#include "core/result.h"
#include "transport/table_file.h"
#include "transport/tables.h"

namespace airlight {

// $XDG_CACHE_HOME/airlight, or else ~/.cache/airlight; empty if the environment names neither.
std::filesystem::path default_cache_folder();

struct CacheSettings {
    std::filesystem::path folder = default_cache_folder();  // made when first needed; empty: nothing is kept
    bool enabled = true;
    // Told, at once, of what did not stop the job: a file that was refused and is baked again, a folder that cannot be written.
    std::function<void(const Error& warning)> warn = [](const Error&) {};
};

// The tables of a description: a function of it alone, wherever they come from. Each pack of sixteen wavelengths is a file; each
// finished order of a pack is saved until the pack is, so that an interrupted bake goes on from there.
// Fails if a wavelength is not covered by the atmosphere, or if `progress` asks to stop; never because of the cache.
Result<Tables> cached_tables(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const BakeSettings& settings,
                             const CacheSettings& cache, const Progress& progress);

// The files that cached_tables() leaves, one for each pack.
std::vector<std::filesystem::path> cache_files(const Atmosphere& atmosphere, std::span<const Wavelength> wavelengths,
                                               const BakeSettings& settings, const CacheSettings& cache);

// What a cache folder holds, by name. Nothing is ever deleted but the state of a bake that has come to its end.
struct CacheEntry {
    std::filesystem::path path;
    std::uintmax_t bytes;
    Result<TableFileSummary> summary;
};
// Fails if the folder cannot be read; a folder that is not there is empty.
Result<std::vector<CacheEntry>> cache_entries(const std::filesystem::path& folder);

}  // namespace airlight
