#include "eval/truth_file.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/files.h"
#include "transport/table_key.h"

namespace airlight {

namespace {

// Raised when the reference, or the choice of directions, gives other numbers for the same description.
constexpr int truth_version = 1;
constexpr std::size_t max_bytes = std::size_t{1} << 26;

std::string hash_text(std::string_view bytes) {
    const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
    return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

void add_row(std::string& text, std::string_view name, std::span<const double> values) {
    text += name;
    for (const double value : values) text += fmt::format(" {}", value);  // the shortest that reads back to the same bits
    text += '\n';
}

// Rows of numbers after their names, one behind the other; the first that is not as asked makes the rest fail.
class RowReader {
public:
    explicit RowReader(std::string_view text) : rest_(text) {}

    std::vector<double> row(std::string_view name, std::size_t count) {
        std::vector<double> values;
        std::string_view line = next_line();
        good_ = good_ && line.starts_with(name);
        if (!good_) return values;
        line.remove_prefix(name.size());
        while (line.starts_with(' ')) {
            double value = 0.0;
            const auto [end, code] = std::from_chars(line.data() + 1, line.data() + line.size(), value);
            if (code != std::errc{} || !std::isfinite(value)) break;
            line.remove_prefix(static_cast<std::size_t>(end - line.data()));
            values.push_back(value);
        }
        good_ = line.empty() && values.size() == count;
        return values;
    }
    std::string_view next_line() {
        const std::size_t end = std::min(rest_.find('\n'), rest_.size());
        const std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        return line;
    }
    bool at_good_end() const { return good_ && rest_.empty(); }

private:
    std::string_view rest_;
    bool good_ = true;
};

constexpr std::string_view seal_name = "seal ";

std::string header(const TruthOrigin& origin) { return fmt::format("airlight truth {}\nkey {}\n", truth_version, origin.key); }

}  // namespace

TruthOrigin truth_origin(const Atmosphere& atmosphere, std::span<const Wavelength> wavelengths, const Condition& condition,
                         std::int64_t paths, std::uint64_t seed) {
    const std::string all = fmt::format("{} {} {} {} {} {}", truth_version, key_text(description_key(atmosphere, wavelengths)),
                                        condition.altitude.value, condition.sun_zenith_deg, paths, seed);
    return {hash_text(all), wavelengths.size()};
}

std::filesystem::path truth_path(const std::filesystem::path& folder, const TruthOrigin& origin) {
    return folder / (origin.key + ".truth");
}

Result<Done> write_truth(const std::filesystem::path& path, const TruthOrigin& origin, const SkyTruth& truth) {
    std::string text = header(origin);
    text += "condition " + truth.name + '\n';
    for (const RadianceEstimate& seen : truth.radiance) {
        add_row(text, "radiance_W_m-2_sr-1_nm-1", seen.radiance_W_m2_sr_nm);
        add_row(text, "standard_error", seen.standard_error);
    }
    if (truth.irradiance) {
        add_row(text, "direct_W_m-2_nm-1", truth.irradiance->direct_W_m2_nm);
        add_row(text, "diffuse_W_m-2_nm-1", truth.irradiance->diffuse_W_m2_nm);
        add_row(text, "standard_error", truth.irradiance->standard_error);
    }
    return write_file(path, text + std::string(seal_name) + hash_text(text) + '\n');
}

Result<SkyTruth> read_truth(const std::filesystem::path& path, const TruthOrigin& origin, const Atmosphere& atmosphere,
                            const Condition& condition) {
    const Result<std::string> bytes = read_file(path, max_bytes);
    if (!bytes) return bytes.error();
    const Error damaged{path.string(), "is no undamaged truth of this comparison", "It is computed again."};
    const std::size_t seal = bytes->rfind(seal_name);
    const std::string_view text = std::string_view(*bytes).substr(0, std::min(seal, bytes->size()));
    if (seal == std::string::npos || bytes->substr(seal) != std::string(seal_name) + hash_text(text) + '\n') return damaged;
    if (!text.starts_with(header(origin))) return damaged;

    SkyTruth truth{condition_text(condition), condition, judged_directions(atmosphere, condition), {}, {}};
    RowReader reader(text.substr(header(origin).size()));
    reader.next_line();  // the condition, for people
    for (std::size_t i = 0; i < truth.directions.size(); ++i) {
        std::vector<double> radiance = reader.row("radiance_W_m-2_sr-1_nm-1", origin.wavelengths);
        truth.radiance.push_back({std::move(radiance), reader.row("standard_error", origin.wavelengths)});
    }
    if (condition.altitude <= atmosphere.top_altitude) {
        std::vector<double> direct = reader.row("direct_W_m-2_nm-1", origin.wavelengths);
        std::vector<double> diffuse = reader.row("diffuse_W_m-2_nm-1", origin.wavelengths);
        truth.irradiance = IrradianceEstimate{std::move(direct), std::move(diffuse), reader.row("standard_error", origin.wavelengths)};
    }
    if (!reader.at_good_end()) return damaged;
    return truth;
}

}  // namespace airlight
