// The key of tables: a hash of all that they are a function of, and of nothing else.
// The bytes that are hashed: docs/table-file.md. Uses the description and the settings of a bake; knows nothing of files.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "transport/bake.h"

namespace airlight {

struct TableKey {
    std::uint64_t high = 0;
    std::uint64_t low = 0;
    friend bool operator==(const TableKey&, const TableKey&) = default;
};

// 32 hexadecimal digits.
std::string key_text(const TableKey& key);

// Every field of the description and of the settings enters, to the last bit, but for the names that people gave to
// the atmosphere and to its constituents: they send no light. The same on every machine and in every locale.
TableKey table_key(const Atmosphere& atmosphere, std::span<const Wavelength> wavelengths, const BakeSettings& settings);

// Of the description alone, for what is computed from it without tables.
TableKey description_key(const Atmosphere& atmosphere, std::span<const Wavelength> wavelengths);

}  // namespace airlight
