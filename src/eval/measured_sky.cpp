#include "eval/measured_sky.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/files.h"
#include "units/text.h"

namespace airlight {

namespace {

constexpr std::size_t max_bytes = std::size_t{1} << 28;
constexpr const char* layout =
    "SkyColumns are time, sun_zenith_deg, sun_azimuth_deg, view_zenith_deg, view_azimuth_deg and wavelengths in nm.";

std::vector<std::string> cells_of(std::string_view line) {
    std::vector<std::string> cells(1);
    for (const char c : line)
        if (c == ',') cells.emplace_back();
        else if (c != '\r') cells.back() += c;
    return cells;
}

// The places of the columns that are read.
struct SkyColumns {
    std::size_t count, time, sun_zenith, sun_azimuth, view_zenith, view_azimuth;
    std::vector<std::size_t> bands;
    std::vector<Wavelength> wavelengths;
};

Result<SkyColumns> columns_of(const std::vector<std::string>& head, Wavelength lowest, Wavelength highest) {
    SkyColumns columns{head.size(), 0, 0, 0, 0, 0, {}, {}};
    const std::pair<const char*, std::size_t*> named[] = {{"time", &columns.time},
                                                          {"sun_zenith_deg", &columns.sun_zenith},
                                                          {"sun_azimuth_deg", &columns.sun_azimuth},
                                                          {"view_zenith_deg", &columns.view_zenith},
                                                          {"view_azimuth_deg", &columns.view_azimuth}};
    for (const auto& [name, place] : named) {
        const auto found = std::find(head.begin(), head.end(), name);
        if (found == head.end()) return Error{"", fmt::format("the column {} is missing from the head", name), layout};
        *place = static_cast<std::size_t>(found - head.begin());
    }
    for (std::size_t i = 0; i < head.size(); ++i) {
        const Result<double> number = parse_number(head[i]);
        if (!number || *number * nm < lowest || *number * nm > highest) continue;
        if (!columns.wavelengths.empty() && *number * nm <= columns.wavelengths.back())
            return Error{"", fmt::format("the column {} does not follow a shorter wavelength", head[i]), layout};
        columns.bands.push_back(i);
        columns.wavelengths.push_back(*number * nm);
    }
    if (columns.bands.empty())
        return Error{"", fmt::format("no column is a wavelength from {:g} to {:g} nm", lowest.in(nm), highest.in(nm)), layout};
    return columns;
}

// Adds a row to the sky of its time.
Result<Done> add_row(const std::vector<std::string>& head, const std::vector<std::string>& cells, const SkyColumns& columns,
                     MeasuredSky& measured) {
    if (cells.size() != head.size()) return Error{"", fmt::format("has {} cells, the head has {}", cells.size(), head.size()), ""};
    Error wrong;
    const auto number = [&](std::size_t i, double lowest, double highest) {
        const Result<double> value = parse_number(cells[i]);
        if (value && *value >= lowest && *value <= highest) return *value;
        wrong = {"", fmt::format("column {}: \"{}\" is no number from {:g} to {:g}", head[i], cells[i], lowest, highest), ""};
        return 0.0;
    };
    const double sun_zenith = number(columns.sun_zenith, 0.0, 180.0), sun_azimuth = number(columns.sun_azimuth, -360.0, 360.0),
                 view_zenith = number(columns.view_zenith, 0.0, 180.0), view_azimuth = number(columns.view_azimuth, -360.0, 360.0);
    RadianceEstimate seen;
    for (const std::size_t band : columns.bands) seen.radiance_W_m2_sr_nm.push_back(number(band, 0.0, 1e9));
    if (!wrong.what.empty()) return wrong;
    seen.standard_error.assign(seen.radiance_W_m2_sr_nm.size(), 0.0);

    const std::string name = fmt::format("{}, sun {:.1f}°", cells[columns.time], sun_zenith);
    if (measured.skies.empty() || measured.skies.back().name != name) measured.skies.push_back({name, {0.0 * m, sun_zenith}, {}, {}, {}});
    measured.skies.back().directions.push_back({{view_zenith * deg, (view_azimuth - sun_azimuth) * deg}, view_zenith <= 90.0});
    measured.skies.back().radiance.push_back(std::move(seen));
    return Done{};
}

}  // namespace

Result<MeasuredSky> read_measured_sky(const std::filesystem::path& path, Wavelength lowest, Wavelength highest) {
    const Result<std::string> text = read_file(path, max_bytes);
    if (!text) return text.error();
    MeasuredSky measured;
    std::vector<std::string> head;
    SkyColumns columns{};
    std::size_t line_number = 0;
    for (std::string_view rest = *text; !rest.empty();) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view line = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        ++line_number;
        const std::string where = fmt::format("{}:{}", path.string(), line_number);
        if (line.empty() || line.starts_with('#')) continue;
        if (head.empty()) {
            head = cells_of(line);
            Result<SkyColumns> found = columns_of(head, lowest, highest);
            if (!found) return at(where, found.error());
            columns = std::move(*found);
        } else if (const Result<Done> added = add_row(head, cells_of(line), columns, measured); !added) {
            return at(where, added.error());
        }
    }
    if (measured.skies.empty()) return Error{path.string(), "holds no measured direction", layout};
    measured.wavelengths = columns.wavelengths;
    return measured;
}

}  // namespace airlight
