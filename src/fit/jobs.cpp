#include "fit/jobs.h"

#include <xxhash.h>

#include <bit>
#include <cstring>
#include <system_error>

#include "core/files.h"

namespace airlight {

static_assert(std::endian::native == std::endian::little, "job files are written in the machine's own order of bytes");

namespace {

constexpr std::string_view magic = "airlight job 1\n";
constexpr std::size_t checksum_bytes = 8;

template <class T>
void append(std::string& bytes, const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

// magic, key, count, numbers, checksum of all before it
std::string file_bytes(const TableKey& key, std::span<const double> numbers) {
    std::string bytes(magic);
    append(bytes, key.high);
    append(bytes, key.low);
    append(bytes, static_cast<std::uint64_t>(numbers.size()));
    bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes());
    append(bytes, static_cast<std::uint64_t>(XXH3_64bits(bytes.data(), bytes.size())));
    return bytes;
}

}  // namespace

JobKey& JobKey::add(std::string_view text) {
    append(bytes_, static_cast<std::uint64_t>(text.size()));
    bytes_.append(text);
    return *this;
}
JobKey& JobKey::add(std::span<const double> numbers) {
    append(bytes_, static_cast<std::uint64_t>(numbers.size()));
    for (const double x : numbers) append(bytes_, x == 0.0 ? 0.0 : x);  // -0 is 0
    return *this;
}
JobKey& JobKey::add(const TableKey& key) {
    append(bytes_, key.high);
    append(bytes_, key.low);
    return *this;
}
TableKey JobKey::hash() const {
    const XXH128_hash_t hash = XXH3_128bits(bytes_.data(), bytes_.size());
    return {hash.high64, hash.low64};
}

std::optional<std::vector<double>> JobStore::load(const TableKey& key) const {
    std::error_code failed;
    if (folder_.empty() || !std::filesystem::exists(path(key), failed)) return {};
    const Result<std::string> read = read_file(path(key));
    const std::size_t head = magic.size() + 24;
    if (!read || read->size() < head + checksum_bytes || (read->size() - head - checksum_bytes) % sizeof(double) != 0) return {};
    std::vector<double> numbers((read->size() - head - checksum_bytes) / sizeof(double));
    std::memcpy(numbers.data(), read->data() + head, numbers.size() * sizeof(double));
    if (*read != file_bytes(key, numbers)) return {};
    return numbers;
}

Result<Done> JobStore::save(const TableKey& key, std::span<const double> numbers) const {
    if (folder_.empty()) return Done{};
    std::error_code failed;
    std::filesystem::create_directories(folder_, failed);
    if (failed)
        return Error{folder_.string(), "the folder of finished jobs cannot be made: " + failed.message(), "Choose another with --cache."};
    return write_file(path(key), file_bytes(key, numbers));
}

}  // namespace airlight
