// A folder of a test's own, empty at first and gone at the end.
#pragma once

#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <string>

namespace airlight::test {

struct TemporaryFolder {
    std::filesystem::path path = std::filesystem::temp_directory_path() / name();
    TemporaryFolder() { std::filesystem::create_directories(path); }
    ~TemporaryFolder() { std::filesystem::remove_all(path); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

private:
    static std::string name() {
        static std::atomic<int> count = 0;
        return "airlight-test-" + std::to_string(::getpid()) + "-" + std::to_string(++count);
    }
};

}  // namespace airlight::test
