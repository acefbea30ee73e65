// `airlight bake`: the tables of an atmosphere, made ahead and kept.

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <memory>

#include "atmosphere/atmosphere_file.h"
#include "command.h"
#include "core/files.h"
#include "interrupt.h"
#include "spectrum/wavelength_grid.h"
#include "transport/table_cache.h"

namespace airlight::cli {

namespace {

struct BakeOptions {
    std::string atmosphere;
    std::string wavelengths = "standard";
    int orders = BakeSettings{}.orders;
    std::string sizes = table_sizes_text({});
    std::string cache = "";
    std::string output = "";
    bool list = false;
    bool quiet = false;
};

struct Job {
    Atmosphere atmosphere;
    std::vector<Wavelength> wavelengths;
    BakeSettings settings;
    CacheSettings cache;
};

CacheSettings cache_of(const BakeOptions& given) {
    CacheSettings cache;
    if (!given.cache.empty()) cache.folder = given.cache;
    cache.warn = [](const Error& warning) { fmt::print(stderr, "warning: {}\n", warning.message()); };
    return cache;
}

Result<Job> job(const BakeOptions& given) {
    Result<Atmosphere> atmosphere = atmosphere_named(given.atmosphere);
    if (!atmosphere) return atmosphere.error();
    const Result<WavelengthGrid> grid = parse_wavelength_grid(given.wavelengths);
    if (!grid) return at("--wavelengths", grid.error());
    const Result<TableSizes> sizes = parse_table_sizes(given.sizes);
    if (!sizes) return at("--sizes", sizes.error());
    const Result<BakeSettings> settings = validated(BakeSettings{.sizes = *sizes, .orders = given.orders});
    if (!settings) return at("--orders", settings.error());
    if (!given.output.empty())
        if (const Result<Done> possible = can_write(given.output); !possible) return possible.error();
    return Job{std::move(*atmosphere), {grid->begin(), grid->end()}, *settings, cache_of(given)};
}

std::string size_text(std::uintmax_t bytes) { return fmt::format("{:.1f} MiB", static_cast<double>(bytes) / (1 << 20)); }

void print_file(const std::filesystem::path& path) {
    std::error_code absent;  // what could not be kept has been said in a warning
    const std::uintmax_t bytes = std::filesystem::file_size(path, absent);
    if (!absent) fmt::print("{}: {}\n", path.string(), size_text(bytes));
}

Result<Done> save(const std::filesystem::path& path, const Job& job, const Tables& tables) {
    std::vector<PackTables> packs;
    for (const Tables::Pack& pack : tables.packs()) packs.push_back(pack.tables);
    return write_tables(path, table_origin(job.atmosphere, job.wavelengths, job.settings), packs);
}

Result<Done> bake(const BakeOptions& given) {
    const Interrupt interrupt;
    const Result<Job> asked = job(given);
    if (!asked) return asked.error();
    const auto start = std::chrono::steady_clock::now();
    ProgressLine line(given.quiet);
    const Result<Tables> tables =
        cached_tables(asked->atmosphere, asked->wavelengths, asked->settings, asked->cache, line.progress(interrupt.token()));
    if (!tables) return tables.error();
    if (!given.output.empty()) {
        if (const Result<Done> saved = save(given.output, *asked, *tables); !saved) return saved.error();
        print_file(given.output);
    }
    for (const std::filesystem::path& path : cache_files(asked->atmosphere, asked->wavelengths, asked->settings, asked->cache))
        print_file(path);
    fmt::print("{} wavelengths, {:.1f} s\n", asked->wavelengths.size(),
               std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    return Done{};
}

// A name that a stranger's file may give, fit for a terminal.
std::string printable(std::string name) {
    for (char& c : name)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
    return name;
}

std::string entry_text(const CacheEntry& entry) {
    if (!entry.summary) return entry.summary.error().what;
    const TableFileSummary& s = *entry.summary;
    const std::string state = s.finished ? "" : fmt::format(", begun: {} orders done", s.orders_done);
    return fmt::format("{}, {} wavelengths, {:g} to {:g} nm{}", printable(s.name), s.wavelengths.size(), s.wavelengths.front().in(nm),
                       s.wavelengths.back().in(nm), state);
}

Result<Done> list(const std::filesystem::path& folder) {
    const Result<std::vector<CacheEntry>> entries = cache_entries(folder);
    if (!entries) return entries.error();
    std::uintmax_t bytes = 0;
    for (const CacheEntry& entry : *entries) {
        fmt::print("{}: {}, {}\n", entry.path.filename().string(), size_text(entry.bytes), entry_text(entry));
        bytes += entry.bytes;
    }
    fmt::print("{}: {} files, {}\n", folder.string(), entries->size(), size_text(bytes));
    return Done{};
}

}  // namespace

Command bake_command(CLI::App& airlight) {
    const auto given = std::make_shared<BakeOptions>();
    CLI::App* bake_app = airlight.add_subcommand("bake", "Make the tables of an atmosphere ahead, so that a later start takes no time.");
    bake_app->add_option("atmosphere", given->atmosphere, "a preset or a file; see docs/atmosphere-file.md")->option_text("<atmosphere>");
    bake_app->add_option("--wavelengths", given->wavelengths, "in nm: 360:830:16 (first, last, count), 450,550,650, or standard")
        ->option_text("<grid>")
        ->capture_default_str();
    bake_app->add_option("--orders", given->orders, "orders of scattering computed, 1 to 100; the rest is extrapolated from 3 on")
        ->option_text("<count>")
        ->capture_default_str();
    bake_app->add_option("--sizes", given->sizes, "texels: sun x azimuth x view x altitude, transmittance")
        ->option_text("<sizes>")
        ->capture_default_str();
    bake_app->add_option("--cache", given->cache, "where tables are kept (default: $XDG_CACHE_HOME/airlight or ~/.cache/airlight)")
        ->option_text("<folder>");
    bake_app->add_option("-o,--output", given->output, "also write one file of all tables; see docs/table-file.md")->option_text("<file>");
    bake_app->add_flag("--list", given->list, "print what the cache holds, and bake nothing");
    bake_app->add_flag("--quiet", given->quiet, "no progress on standard error");
    bake_app->footer(
        help_footer("a line a file, with its size; then the time taken. Ctrl-C stops, and the same command goes on from there.",
                    "airlight bake earth-clear --sizes 16x8x16x8 --orders 2 --cache tables"));
    bake_app->callback([given] {
        if (given->atmosphere.empty() && !given->list) throw CLI::RequiredError("<atmosphere>");
    });
    return {bake_app, [given] { return given->list ? list(cache_of(*given).folder) : bake(*given); }};
}

}  // namespace airlight::cli
