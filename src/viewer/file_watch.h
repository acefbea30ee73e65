// Files that others change while the program runs.
// Uses nothing; asks the file system.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace airlight::viewer {

class FileWatch {
public:
    // The files as they are now; one that is not there may come. Of a folder, all files in it and below.
    explicit FileWatch(std::vector<std::filesystem::path> paths);

    // Whether one of them was written, came or went since the last time that this was asked, or since it was made.
    bool changed();

private:
    std::vector<std::filesystem::path> paths_;
    std::uint64_t seen_;
};

}  // namespace airlight::viewer
