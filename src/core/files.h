// Whole files, read with a bound and written all or nothing.
// Uses nothing else of the project.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "core/result.h"

namespace airlight {

// The bytes of a file. Fails, naming the path, if it cannot be read or is larger than `max_bytes`.
Result<std::string> read_file(const std::filesystem::path& path, std::size_t max_bytes = std::size_t{1} << 30);

// Writes `bytes` under a temporary name beside `path`, flushes them to the disk and renames: what stood at `path`
// stays whole until the new file is. Fails, and leaves nothing behind, if the folder cannot be written or the disk is full.
Result<Done> write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);
Result<Done> write_file(const std::filesystem::path& path, std::string_view text);
// The same with the pieces one behind the other.
Result<Done> write_file(const std::filesystem::path& path, std::span<const std::span<const std::byte>> pieces);

// Whether a file may be written at `path`: its folder is there and may be written to. For saying so before long work, not after.
Result<Done> can_write(const std::filesystem::path& path);

// The name under which write_file() collects what is to become `path`, of this thread's own; for writers that need
// a path.
std::filesystem::path temporary_name(const std::filesystem::path& path);

// The last step of write_file(): flushes `temporary` and gives it its final name.
Result<Done> publish_file(const std::filesystem::path& temporary, const std::filesystem::path& path);

}  // namespace airlight
