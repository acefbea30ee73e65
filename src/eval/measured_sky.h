// Measured skies: spectral radiance in many directions at some times of a day, from a CSV file.
// Layout: lines that begin with # are comments; a head that names the columns; a row a direction. Columns: time, sun_zenith_deg,
// sun_azimuth_deg, view_zenith_deg, view_azimuth_deg, and one for each wavelength in nm, which is its name, of radiance in
// W m-2 sr-1 nm-1; others are not looked at. Uses the truth; knows nothing of models.
#pragma once

#include <filesystem>

#include "eval/truth.h"

namespace airlight {

struct MeasuredSky {
    std::vector<Wavelength> wavelengths;
    std::vector<SkyTruth> skies;  // one a time, seen from the ground; without standard errors
};

// The wavelengths from `lowest` to `highest` of a file.
// Fails, naming the line and the column, if a column is missing or a cell is no number.
Result<MeasuredSky> read_measured_sky(const std::filesystem::path& path, Wavelength lowest, Wavelength highest);

}  // namespace airlight
