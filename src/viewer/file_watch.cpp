#include "viewer/file_watch.h"

#include <system_error>
#include <utility>

namespace airlight::viewer {

namespace {

using std::filesystem::path;

// Sums of well mixed values: the order in which a folder is listed does not matter.
std::uint64_t mixed(std::uint64_t x) {  // [Steele2014], the finalizer of SplitMix64
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

// A number that differs, but for a chance of 2^-64, when the file was written, came or went.
std::uint64_t state_of_file(const path& file) {
    std::error_code error;
    const auto time = std::filesystem::last_write_time(file, error);
    if (error) return 0;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    return mixed(std::filesystem::hash_value(file) ^ mixed(static_cast<std::uint64_t>(time.time_since_epoch().count()) + mixed(size)));
}

std::uint64_t state_of(const std::vector<path>& paths) {
    std::uint64_t sum = 0;
    for (const path& watched : paths) {
        std::error_code error;
        if (!std::filesystem::is_directory(watched, error)) {
            sum += state_of_file(watched);
            continue;
        }
        for (auto entry = std::filesystem::recursive_directory_iterator(watched, error); entry != std::filesystem::end(entry);
             entry.increment(error)) {
            std::error_code unreadable;
            if (entry->is_regular_file(unreadable)) sum += state_of_file(entry->path());
        }
    }
    return sum;
}

}  // namespace

FileWatch::FileWatch(std::vector<path> paths) : paths_(std::move(paths)), seen_(state_of(paths_)) {}

bool FileWatch::changed() {
    const std::uint64_t now = state_of(paths_);
    return std::exchange(seen_, now) != now;
}

}  // namespace airlight::viewer
