// Gives the bytes of a table file, however they were changed, the checksums that fit them: so that what stands behind the
// checksums is tested too. Written from docs/table-file.md, not from the code that it tests.
#pragma once

#include <xxhash.h>

#include <cstdint>
#include <cstring>
#include <string>

namespace airlight::test {

template <class T>
T field(const std::string& file, std::size_t offset) {
    T value;
    std::memcpy(&value, file.data() + offset, sizeof value);
    return value;
}

template <class T>
void set_field(std::string& file, std::size_t offset, T value) {
    std::memcpy(file.data() + offset, &value, sizeof value);
}

// Where the i-th entry of the list of sections stands.
inline std::size_t entry_offset(const std::string& file, std::size_t i) {
    return 128 + 8 * std::size_t{field<std::uint32_t>(file, 40)} + 64 * i;
}

// A file too short for what its head says is left as it is.
inline void seal(std::string& file) {
    if (file.size() < 128) return;
    const std::size_t sections = field<std::uint32_t>(file, 44);
    const std::size_t front = entry_offset(file, sections);
    if (front > file.size()) return;
    for (std::size_t i = 0; i < sections; ++i) {
        const std::size_t entry = entry_offset(file, i);
        const auto offset = field<std::uint64_t>(file, entry + 40), bytes = field<std::uint64_t>(file, entry + 48);
        if (offset <= file.size() && bytes <= file.size() - offset) set_field(file, entry + 56, XXH3_64bits(file.data() + offset, bytes));
    }
    set_field(file, 56, std::uint64_t{0});
    set_field(file, 56, std::uint64_t{XXH3_64bits(file.data(), front)});
}

}  // namespace airlight::test
