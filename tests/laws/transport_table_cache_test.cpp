// The cache of tables: it changes how long a description takes, never what comes of it.

#include <doctest/doctest.h>

#include <thread>

#include "core/files.h"
#include "tools/small_tables.h"
#include "tools/temporary_folder.h"
#include "transport/table_cache.h"

using namespace airlight;
using namespace airlight::test;

namespace fs = std::filesystem;

namespace {

// Calls of cached_tables() in a folder of their own, and what they warned of.
struct Caching {
    TemporaryFolder folder;
    std::vector<std::string> warnings;
    CacheSettings settings{
        .folder = folder.path / "cache", .enabled = true, .warn = [this](const Error& e) { warnings.push_back(e.message()); }};
    std::vector<Wavelength> wavelengths = some_wavelengths(18);
    BakeSettings bake = tiny_bake(4);

    Result<Tables> tables(const Progress& progress = {}) { return cached_tables(one_gas(), wavelengths, bake, settings, progress); }
    std::vector<fs::path> files() const { return cache_files(one_gas(), wavelengths, bake, settings); }
    Tables right() const { return *bake_tables(one_gas(), wavelengths, bake, {}); }
    std::size_t file_count() const {
        return fs::exists(settings.folder) ? static_cast<std::size_t>(std::distance(fs::directory_iterator(settings.folder), {})) : 0;
    }
};

bool same_bits(const Tables& a, const Tables& b) {
    if (a.packs().size() != b.packs().size()) return false;
    for (std::size_t i = 0; i < a.packs().size(); ++i)
        if (!test::same_bits(a.packs()[i].tables, b.packs()[i].tables)) return false;
    return true;
}

// With it, a bake of any order fails: tables can only come from files.
Progress stopped() {
    std::stop_source stop;
    stop.request_stop();
    Progress progress;
    progress.stop = stop.get_token();
    return progress;
}

bool says(const std::string& message, const std::string& words) { return message.find(words) != std::string::npos; }

}  // namespace

TEST_CASE("a second call bakes nothing, and gives the same bits") {
    Caching cache;
    REQUIRE(cache.tables());
    CHECK(cache.file_count() == 2);  // two packs, and no state left over
    for (const fs::path& file : cache.files()) CHECK(fs::exists(file));
    const Result<Tables> again = cache.tables(stopped());
    REQUIRE(again);
    CHECK(same_bits(*again, cache.right()));
    CHECK(cache.warnings.empty());
}

TEST_CASE("a bake that was interrupted goes on from its last finished order, and keeps the packs before") {
    Caching cache;
    cache.bake.sizes.sun = cache.bake.sizes.altitude = 8;  // 64 points an order: progress is reported at the last of them
    std::stop_source stop;
    Progress progress;
    progress.stop = stop.get_token();
    // The second pack is the second half; its third order of four ends at 0.5 + 0.5 * 0.75.
    progress.report = [&](std::string_view, double fraction) {
        if (fraction >= 0.87) stop.request_stop();
    };
    const Result<Tables> interrupted = cache.tables(progress);
    REQUIRE(!interrupted);
    CHECK(says(interrupted.error().message(), "interrupted"));
    const std::vector<CacheEntry> entries = *cache_entries(cache.settings.folder);
    REQUIRE(entries.size() == 2);
    const std::size_t state = entries[0].path == cache.files()[0] ? 1 : 0;
    CHECK(entries[1 - state].summary->finished);
    CHECK(!entries[state].summary->finished);
    CHECK(entries[state].summary->orders_done == 2);

    double least = 1.0;
    progress = Progress{};
    progress.report = [&](std::string_view, double fraction) { least = std::min(least, fraction); };
    const Result<Tables> resumed = cache.tables(progress);
    REQUIRE(resumed);
    CHECK(least == doctest::Approx(0.875));  // the first report is that of the third order of the second pack
    CHECK(same_bits(*resumed, cache.right()));
    CHECK(cache.file_count() == 2);
    CHECK(cache.tables(stopped()));
    CHECK(cache.warnings.empty());
}

TEST_CASE("a damaged or foreign file in the cache is told of, baked again and replaced") {
    Caching cache;
    REQUIRE(cache.tables());
    const std::vector<fs::path> files = cache.files();
    const std::string good = *read_file(files[0]);
    std::string damaged = good;
    damaged[4096] = static_cast<char>(damaged[4096] ^ 1);
    struct Case {
        std::string bytes, words;
    };
    for (const Case& c :
         {Case{damaged, "is damaged: checksum of section transmittance"}, Case{good.substr(0, 1000), "is truncated: 1000 of "},
          Case{"not at all", "is not a table file"}, Case{*read_file(files[1]), "belongs to another"}}) {
        CAPTURE(c.words);
        cache.warnings.clear();
        REQUIRE(write_file(files[0], c.bytes));
        const Result<Tables> tables = cache.tables();
        REQUIRE(tables);
        CHECK(same_bits(*tables, cache.right()));
        REQUIRE(cache.warnings.size() == 1);
        CHECK(says(cache.warnings[0], c.words));
        CHECK(says(cache.warnings[0], files[0].string()));
        CHECK(says(cache.warnings[0], "It is baked again."));
        CHECK(*read_file(files[0]) == good);
    }
}

TEST_CASE("a damaged state is told of, and the bake begins anew") {
    Caching cache;
    fs::path state = cache.files()[0];
    state.replace_extension(".begun");
    fs::create_directories(cache.settings.folder);
    REQUIRE(write_file(state, "half a state"));
    const Result<Tables> tables = cache.tables();
    REQUIRE(tables);
    CHECK(same_bits(*tables, cache.right()));
    REQUIRE(cache.warnings.size() == 1);
    CHECK(says(cache.warnings[0], "is not a table file"));
    CHECK(!fs::exists(state));
}

TEST_CASE("a folder that cannot be made is one warning, and the tables come all the same") {
    Caching cache;
    REQUIRE(write_file(cache.settings.folder, "a file where the folder should be"));
    const Result<Tables> tables = cache.tables();
    REQUIRE(tables);
    CHECK(same_bits(*tables, cache.right()));
    REQUIRE(cache.warnings.size() == 1);
    CHECK(says(cache.warnings[0], "the cache folder cannot be made"));
}

TEST_CASE("a full disk is a warning, leaves no file, and the tables come all the same") {
    Caching cache;
    cache.wavelengths = some_wavelengths(1);
    cache.bake.orders = 1;  // no state is saved
    fs::create_directories(cache.settings.folder);
    fs::create_symlink("/dev/full", temporary_name(cache.files()[0]));  // what write_file() writes to, is full
    const Result<Tables> tables = cache.tables();
    REQUIRE(tables);
    CHECK(same_bits(*tables, cache.right()));
    REQUIRE(cache.warnings.size() == 1);
    CHECK(says(cache.warnings[0], "No space left on device"));
    CHECK(cache.file_count() == 0);
}

TEST_CASE("without a cache nothing is written") {
    Caching cache;
    cache.settings.enabled = false;
    REQUIRE(cache.tables());
    CHECK(cache.files().empty());
    CHECK(cache.file_count() == 0);
    cache.settings = {.folder = {}, .enabled = true, .warn = cache.settings.warn};
    REQUIRE(cache.tables());
    REQUIRE(cache.warnings.size() == 1);
    CHECK(says(cache.warnings[0], "names no cache folder"));
}

TEST_CASE("two that bake the same tables at once both get them, and leave whole files") {
    Caching cache;
    std::vector<std::unique_ptr<Tables>> got(4);
    {
        std::vector<std::jthread> threads;
        for (auto& tables : got)
            threads.emplace_back([&] {
                CacheSettings settings = cache.settings;
                settings.warn = [](const Error& e) { MESSAGE(e.message()); };
                tables = std::make_unique<Tables>(*cached_tables(one_gas(), cache.wavelengths, cache.bake, settings, {}));
            });
    }
    const Tables right = cache.right();
    for (const auto& tables : got) CHECK(same_bits(*tables, right));
    CHECK(cache.tables(stopped()));
}

TEST_CASE("the cache folder follows the environment") {
    const char* home = std::getenv("HOME");
    const std::string kept_home = home != nullptr ? home : "";
    ::setenv("XDG_CACHE_HOME", "/somewhere", 1);
    CHECK(default_cache_folder() == "/somewhere/airlight");
    ::setenv("XDG_CACHE_HOME", "relative", 1);
    ::setenv("HOME", "/home/someone", 1);
    CHECK(default_cache_folder() == "/home/someone/.cache/airlight");
    ::unsetenv("HOME");
    CHECK(default_cache_folder().empty());
    ::unsetenv("XDG_CACHE_HOME");
    if (home != nullptr) ::setenv("HOME", kept_home.c_str(), 1);
}

TEST_CASE("wavelengths that the atmosphere does not cover are refused") {
    Atmosphere atmosphere = one_gas();
    atmosphere.ground_albedo = *SpectrumOf<Number>::of({{400.0 * nm, Number(0.1)}, {700.0 * nm, Number(0.2)}});
    const Result<Tables> tables = cached_tables(atmosphere, {300.0 * nm}, tiny_bake(1), {.folder = {}, .enabled = false}, {});
    REQUIRE(!tables);
}

TEST_CASE("table sizes read back, and wrong ones are refused") {
    CHECK(*parse_table_sizes("64x16x32x32") == TableSizes{});
    const TableSizes sizes{8, 9, 2, 3, 4, 5};
    CHECK(table_sizes_text(sizes) == "2x3x4x5,8x9");
    CHECK(*parse_table_sizes(table_sizes_text(sizes)) == sizes);
    for (const char* wrong : {"", "x", "2x3x4", "2x3x4x5x6", "2x3x4x5,", "2x3x4x5,8", "2x3x4x5,8x9,1", "2x3x4x5 ", "ax3x4x5",
                              "2x3x4x99999999999", "1x3x4x5", "-2x3x4x5", "2x3x4x5000", "4096x4096x4096x4096", "2x3x4x5,1x9"}) {
        CAPTURE(wrong);
        CHECK(!parse_table_sizes(wrong));
    }
    CHECK(!validated(BakeSettings{.sizes = {}, .orders = 0}));
    CHECK(!validated(BakeSettings{.sizes = {}, .orders = 101}));
    CHECK(validated(BakeSettings{}));
}
