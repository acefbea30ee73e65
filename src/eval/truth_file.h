// The truth under one condition as a small text file, sealed by a checksum: so that an interrupted comparison goes on.
// Uses the truth; knows nothing of models.
#pragma once

#include <cstdint>
#include <filesystem>

#include "eval/truth.h"

namespace airlight {

// All that a truth by the reference is a function of.
struct TruthOrigin {
    std::string key;  // 32 hexadecimal digits: also the file's name
    std::size_t wavelengths;
};
TruthOrigin truth_origin(const Atmosphere& atmosphere, std::span<const Wavelength> wavelengths, const Condition& condition,
                         std::int64_t paths, std::uint64_t seed);

std::filesystem::path truth_path(const std::filesystem::path& folder, const TruthOrigin& origin);

Result<Done> write_truth(const std::filesystem::path& path, const TruthOrigin& origin, const SkyTruth& truth);

// Fails, naming the file, if it is damaged or of another origin.
Result<SkyTruth> read_truth(const std::filesystem::path& path, const TruthOrigin& origin, const Atmosphere& atmosphere,
                            const Condition& condition);

}  // namespace airlight
