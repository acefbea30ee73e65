#include "transport/table_cache.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <optional>
#include <set>
#include <string>
#include <system_error>

#include "atmosphere/validate.h"

namespace airlight {

namespace {

constexpr const char* tables_suffix = ".tables";
constexpr const char* state_suffix = ".begun";

std::filesystem::path cache_file(const std::filesystem::path& folder, const TableOrigin& origin, const char* suffix) {
    return folder / (key_text(origin.key) + suffix);
}

bool is_there(const std::filesystem::path& path) {
    std::error_code failed;
    return std::filesystem::exists(path, failed);
}

// The cache at work in one call: everything that goes wrong in it is a warning, said once.
class Cache {
public:
    explicit Cache(const CacheSettings& settings) : settings_(settings), active_(settings.enabled && !settings.folder.empty()) {
        if (settings.enabled && settings.folder.empty())
            warn({"", "tables are not kept: the environment names no cache folder", "Set XDG_CACHE_HOME or HOME."});
    }

    bool active() const { return active_; }

    std::optional<PackTables> load(const TableOrigin& origin) {
        const std::filesystem::path path = cache_file(settings_.folder, origin, tables_suffix);
        if (!active_ || !is_there(path)) return {};
        Result<std::vector<PackTables>> tables = read_tables(path, origin);
        if (tables) return std::move(tables->front());
        warn_of_rebuild(tables.error());
        return {};
    }

    BakeState load_state(const TableOrigin& origin) {
        const std::filesystem::path path = cache_file(settings_.folder, origin, state_suffix);
        if (!active_ || !is_there(path)) return {};
        Result<BakeState> state = read_bake_state(path, origin);
        if (state) return std::move(*state);
        warn_of_rebuild(state.error());
        return {};
    }

    void save(const TableOrigin& origin, const PackTables& tables) {
        if (!active_) return;
        const Result<Done> saved =
            in_folder([&] { return write_tables(cache_file(settings_.folder, origin, tables_suffix), origin, std::span(&tables, 1)); });
        if (!saved) return warn(saved.error());
        std::error_code ignored;  // the state may not have been there
        std::filesystem::remove(cache_file(settings_.folder, origin, state_suffix), ignored);
    }

    void save_state(const TableOrigin& origin, const BakeState& state) {
        if (!active_) return;
        const Result<Done> saved =
            in_folder([&] { return write_bake_state(cache_file(settings_.folder, origin, state_suffix), origin, state); });
        if (!saved) warn(saved.error());
    }

private:
    template <class Write>
    Result<Done> in_folder(const Write& write) {
        std::error_code failed;
        std::filesystem::create_directories(settings_.folder, failed);
        if (failed)
            return Error{settings_.folder.string(), "the cache folder cannot be made: " + failed.message(),
                         "Tables are not kept; choose another folder."};
        return write();
    }

    void warn_of_rebuild(Error error) {
        error.remedy = "It is baked again.";
        warn(error);
    }
    void warn(const Error& warning) {
        if (said_.insert(warning.message()).second) settings_.warn(warning);
    }

    const CacheSettings& settings_;
    bool active_;
    std::set<std::string> said_;
};

Result<PackTables> cached_pack(const Atmosphere& atmosphere, const TableOrigin& origin, Cache& cache, const Progress& progress) {
    if (std::optional<PackTables> loaded = cache.load(origin)) return std::move(*loaded);
    BakeSteps steps{.from = cache.load_state(origin), .order_done = [&](const BakeState& state) { cache.save_state(origin, state); }};
    Result<PackTables> baked = bake_pack(air_optics(atmosphere, origin.wavelengths), origin.settings, progress, std::move(steps));
    if (!baked) return Error{"", baked.error().what, cache.active() ? "Run the same command again: what was finished is kept." : ""};
    cache.save(origin, *baked);
    return baked;
}

}  // namespace

std::filesystem::path default_cache_folder() {
    // The XDG base directory specification: a path that is not absolute is to be ignored.
    const char* cache = std::getenv("XDG_CACHE_HOME");
    if (cache != nullptr && std::filesystem::path(cache).is_absolute()) return std::filesystem::path(cache) / "airlight";
    const char* home = std::getenv("HOME");
    return home != nullptr && *home != '\0' ? std::filesystem::path(home) / ".cache" / "airlight" : std::filesystem::path();
}

Result<Tables> cached_tables(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const BakeSettings& settings,
                             const CacheSettings& cache_settings, const Progress& progress) {
    assert(!wavelengths.empty());
    if (const Result<Done> covered = covers(atmosphere, wavelengths.front(), wavelengths.back()); !covered) return covered.error();
    const std::vector<std::vector<Wavelength>> groups = packs(wavelengths);
    const double share = 1.0 / static_cast<double>(groups.size());
    Cache cache(cache_settings);
    std::vector<PackTables> tables;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        Result<PackTables> pack = cached_pack(atmosphere, table_origin(atmosphere, groups[i], settings), cache,
                                              part_of(progress, static_cast<double>(i) * share, share));
        if (!pack) return pack.error();
        tables.push_back(std::move(*pack));
    }
    return Tables(atmosphere, std::move(wavelengths), settings, std::move(tables));
}

std::vector<std::filesystem::path> cache_files(const Atmosphere& atmosphere, std::span<const Wavelength> wavelengths,
                                               const BakeSettings& settings, const CacheSettings& cache) {
    std::vector<std::filesystem::path> paths;
    if (!cache.enabled || cache.folder.empty()) return paths;
    for (const std::vector<Wavelength>& group : packs(wavelengths))
        paths.push_back(cache_file(cache.folder, table_origin(atmosphere, group, settings), tables_suffix));
    return paths;
}

Result<std::vector<CacheEntry>> cache_entries(const std::filesystem::path& folder) {
    std::vector<CacheEntry> entries;
    std::error_code failed;
    if (!is_there(folder)) return entries;
    for (std::filesystem::directory_iterator i(folder, failed), end; !failed && i != end; i.increment(failed)) {
        if (!i->is_regular_file(failed)) continue;
        entries.push_back({i->path(), i->file_size(failed), read_table_summary(i->path())});
    }
    if (failed)
        return Error{folder.string(), "the cache folder cannot be read: " + failed.message(), "Check the path and that you may read it."};
    std::sort(entries.begin(), entries.end(), [](const CacheEntry& a, const CacheEntry& b) { return a.path < b.path; });
    return entries;
}

}  // namespace airlight
