#include "core/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

namespace airlight {

namespace {

Error file_error(const std::filesystem::path& path, std::string_view what, int code, std::string remedy = {}) {
    return Error{path.string(), fmt::format("{}: {}", what, std::strerror(code)), std::move(remedy)};
}

// An open file descriptor that closes itself.
class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    explicit operator bool() const { return number_ >= 0; }
    int number() const { return number_; }
    bool close() { return ::close(std::exchange(number_, -1)) == 0; }

private:
    int number_;
};

bool write_all(int descriptor, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return true;
}

}  // namespace

Result<std::string> read_file(const std::filesystem::path& path, std::size_t max_bytes) {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file) return file_error(path, "cannot be read", errno, "Check the path and that you may read it.");
    struct stat status {};
    if (::fstat(file.number(), &status) != 0) return file_error(path, "cannot be read", errno);
    if (S_ISDIR(status.st_mode)) return Error{path.string(), "is a folder, not a file", "Name a file in it."};

    std::string bytes;
    if (status.st_size > 0) bytes.reserve(std::min(static_cast<std::size_t>(status.st_size), max_bytes) + 1);
    char block[1 << 16];
    for (;;) {
        const ssize_t count = ::read(file.number(), block, sizeof block);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return file_error(path, "cannot be read", errno);
        if (count == 0) return bytes;
        bytes.append(block, static_cast<std::size_t>(count));
        if (bytes.size() > max_bytes)
            return Error{path.string(), fmt::format("is larger than the {} bytes that such a file may have", max_bytes), ""};
    }
}

Result<Done> can_write(const std::filesystem::path& path) {
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
        return file_error(path, "cannot be written", errno, "Check that the folder exists and that you may write to it.");
    std::error_code failed;
    if (std::filesystem::is_directory(path, failed)) return Error{path.string(), "is a folder, not a file", "Name a file in it."};
    return Done{};
}

std::filesystem::path temporary_name(const std::filesystem::path& path) {
    std::filesystem::path name = path;
    name += fmt::format(".part{}-{}", ::getpid(), ::gettid());
    return name;
}

Result<Done> publish_file(const std::filesystem::path& temporary, const std::filesystem::path& path) {
    int failed = 0;
    {
        Descriptor file(::open(temporary.c_str(), O_RDONLY | O_CLOEXEC));
        if (!file || ::fsync(file.number()) != 0) failed = errno;
    }
    if (failed == 0 && ::rename(temporary.c_str(), path.c_str()) != 0) failed = errno;
    if (failed == 0) return Done{};
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    return file_error(path, "cannot be written", failed,
                      "Check that the folder exists, that you may write to it, and that the disk is not full.");
}

Result<Done> write_file(const std::filesystem::path& path, std::span<const std::span<const std::byte>> pieces) {
    const std::filesystem::path temporary = temporary_name(path);
    Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
    const bool written = file && std::all_of(pieces.begin(), pieces.end(), [&](auto piece) { return write_all(file.number(), piece); });
    const int code = errno;
    if (written && file.close()) return publish_file(temporary, path);

    std::error_code ignored;
    if (file) std::filesystem::remove(temporary, ignored);
    return file_error(path, "cannot be written", code,
                      "Check that the folder exists, that you may write to it, and that the disk is not full.");
}

Result<Done> write_file(const std::filesystem::path& path, std::span<const std::byte> bytes) {
    return write_file(path, std::span(&bytes, 1));
}

Result<Done> write_file(const std::filesystem::path& path, std::string_view text) {
    return write_file(path, std::as_bytes(std::span(text)));
}

}  // namespace airlight
