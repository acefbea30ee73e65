// Runs a fuzz target over the files of the given folders, without libFuzzer: what once was found stays fixed.
// Each file is also tried cut at every length (in steps for a long one), as a file is that was not written to its end.

#include <filesystem>
#include <string>
#include <vector>

#include "core/files.h"
#include "fuzz.h"

namespace {

void run(std::string_view bytes) {
    // A heap block of the very size, so that a sanitizer sees a read behind the end.
    const std::vector<std::uint8_t> copy(bytes.begin(), bytes.end());
    LLVMFuzzerTestOneInput(copy.data(), copy.size());
}

}  // namespace

int main(int argc, char** argv) {
    std::size_t files = 0;
    for (int i = 1; i < argc; ++i) {
        for (const auto& entry : std::filesystem::directory_iterator(argv[i])) {
            const airlight::Result<std::string> bytes = airlight::read_file(entry.path());
            if (!bytes) {
                std::fprintf(stderr, "%s\n", bytes.error().message().c_str());
                return 1;
            }
            const std::size_t step = bytes->size() / 256 + 1;
            for (std::size_t length = 0; length < bytes->size(); length += step) run(std::string_view(*bytes).substr(0, length));
            run(*bytes);
            ++files;
        }
    }
    std::printf("%zu files\n", files);
    return files > 0 ? 0 : 1;
}
