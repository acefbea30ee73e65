// The eyes and directions of the independent figures' rows.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "figures.h"
#include "skies.h"
#include "transport/reference.h"

namespace airlight::truth {

// For plane_parallel.csv and spherical.csv.
inline View view_of(const Row& row) {
    return {row["eye_altitude_m"] * m, row["view_zenith_deg"] * deg, row["sun_zenith_deg"] * deg, row["relative_azimuth_deg"] * deg};
}

inline std::string name_of(const Row& row) {
    return fmt::format("{} sun {} eye {} km view {} azimuth {}", row.text("case"), row["sun_zenith_deg"], row["eye_altitude_m"] / 1000.0,
                       row["view_zenith_deg"], row["relative_azimuth_deg"]);
}

// Which of the three skies a row is of; 0 for slabs.
inline std::size_t lane_of(const Row& row) {
    const auto found = std::find(sky_names.begin(), sky_names.end(), row.text("case"));
    return found == sky_names.end() ? 0 : static_cast<std::size_t>(found - sky_names.begin());
}

// For exact_sky.csv and measured_sky.csv, whose azimuths are from north.
inline View ground_view_of(const Row& row) {
    return {0.0 * m, row["view_zenith_deg"] * deg, row["sun_zenith_deg"] * deg, (row["view_azimuth_deg"] - row["sun_azimuth_deg"]) * deg};
}

inline std::vector<Wavelength> in_nm(const std::vector<double>& values) {
    std::vector<Wavelength> result;
    for (const double v : values) result.push_back(v * nm);
    return result;
}

// Says that a file is not there, which skips the test.
inline bool absent(const std::vector<Row>& rows, const char* name) {
    if (!rows.empty()) return false;
    fmt::print("[skipped] {} is absent; AIRLIGHT_REFERENCE may name its folder\n", name);
    return true;
}

}  // namespace airlight::truth
