#include "figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace airlight::figures {

std::vector<double> Table::column(std::string_view name) const {
    const auto found = std::find(columns.begin(), columns.end(), name);
    assert(found != columns.end() && !rows.empty());
    const std::size_t i = static_cast<std::size_t>(found - columns.begin()) - rows.front().words.size();
    std::vector<double> values;
    for (const Row& row : rows) values.push_back(row.numbers[i]);
    return values;
}

std::string csv(const Table& table) {
    std::string text = fmt::format("{}\n", fmt::join(table.columns, ","));
    for (const Table::Row& row : table.rows) {
        std::vector<std::string> cells = row.words;
        for (const double x : row.numbers) cells.push_back(std::isnan(x) ? "" : fmt::format("{:.6g}", x));
        text += fmt::format("{}\n", fmt::join(cells, ","));
    }
    return text;
}

Settings small(std::filesystem::path folder) {
    return {.folder = std::move(folder),
            .points = 13,
            .bake = {.sizes = {.transmittance_mu = 64, .transmittance_altitude = 32, .sun = 16, .azimuth = 6, .view = 12, .altitude = 8},
                     .orders = 3},
            .picture_width = 24};
}

std::span<const Figure> figures() {
    static constexpr Figure all[] = {
        {"density_profile", "density of the standard atmosphere beside exponentials", density_profile},
        {"mean_density", "two estimates of the mean density of a path, and the exact one", mean_density},
        {"sky_columns", "air on the way out of the atmosphere by direction and altitude", sky_columns},
        {"phase_functions", "how molecules and aerosol scatter by angle", phase_functions},
        {"sky_by_altitude", "luminance of the sky as the eye climbs", sky_by_altitude},
        {"sky_from_altitudes", "pictures of it from the ground, 16 km and 30 km", sky_from_altitudes},
        {"scattering_orders", "single and multiple scattering from space to the ground", scattering_orders},
        {"rayleigh_coefficient", "half, whole and twice the molecules' scattering", rayleigh_coefficient},
        {"rayleigh_scale_height", "molecules' scale height of 2, 6 and 10 km", rayleigh_scale_height},
        {"mie_coefficient", "half, whole and twice the aerosol's scattering", mie_coefficient},
        {"mie_scale_height", "aerosol's scale height of 1, 2 and 4 km", mie_scale_height},
    };
    return all;
}

const Figure* find_figure(std::string_view name) {
    const auto all = figures();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Figure& figure) { return figure.name == name; });
    return found == all.end() ? nullptr : &*found;
}

}  // namespace airlight::figures
