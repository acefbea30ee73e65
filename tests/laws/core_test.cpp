// Files, errors and results.

#include <doctest/doctest.h>

#include <atomic>
#include <filesystem>

#include "core/files.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "tools/temporary_folder.h"

using namespace airlight;
using test::TemporaryFolder;
namespace fs = std::filesystem;

TEST_CASE("a written file reads back to the same bytes") {
    const TemporaryFolder folder;
    const std::string bytes("one\0two\n", 8);
    REQUIRE(write_file(folder.path / "file", bytes));
    const Result<std::string> read = read_file(folder.path / "file");
    REQUIRE(read);
    CHECK(*read == bytes);
}

TEST_CASE("a file that cannot be written is named in the error and leaves nothing behind") {
    const TemporaryFolder folder;
    const Result<Done> written = write_file(folder.path / "absent" / "file", "text");
    REQUIRE(!written);
    CHECK(written.error().message().find("absent/file: cannot be written: No such file") != std::string::npos);
    CHECK(fs::is_empty(folder.path));
}

TEST_CASE("a full disk loses nothing that was there") {
    if (!fs::exists("/dev/full")) {
        MESSAGE("[skipped] no /dev/full on this system");
        return;
    }
    const TemporaryFolder folder;
    const fs::path file = folder.path / "file";
    REQUIRE(write_file(file, "old"));
    fs::create_symlink("/dev/full", temporary_name(file));  // what write_file() writes to, is full
    CHECK(!write_file(file, "new"));
    CHECK(*read_file(file) == "old");
}

TEST_CASE("a file larger than its bound is refused") {
    const TemporaryFolder folder;
    REQUIRE(write_file(folder.path / "file", "0123456789"));
    CHECK(read_file(folder.path / "file", 10));
    CHECK(!read_file(folder.path / "file", 9));
    CHECK(!read_file(folder.path));
}

TEST_CASE("an error seen from further out names both places") {
    const Error error = at("earth.toml", Error{"line 14", "scale_height is -1.2 km: it must be above 0 m", "Write a positive length."});
    CHECK(error.message() == "earth.toml: line 14: scale_height is -1.2 km: it must be above 0 m\n  Write a positive length.");
}

TEST_CASE("a slip of the pen finds the word that was meant, another word finds none") {
    CHECK(nearest_word("scale_heigth", "scale_height profile albedo") == "scale_height");
    CHECK(nearest_word("temperature", "scale_height profile albedo").empty());
}

TEST_CASE("a parallel loop visits each index once, on any number of threads") {
    for (const int threads : {1, 2, 5}) {
        const ThreadLimit limit(threads);
        std::vector<std::atomic<int>> visits(1000);
        parallel_for(visits.size(), [&](std::size_t i) { ++visits[i]; });
        for (const auto& count : visits) CHECK(count == 1);
    }
}

TEST_CASE("durations are written as people say them") {
    CHECK(duration_text(3.2) == "3 s");
    CHECK(duration_text(125) == "2 min 05 s");
    CHECK(duration_text(4200) == "1 h 10 min");
}
