// Figures of the theses, computed anew by this project: each is a table of numbers and, where it shows skies, pictures.
// What a figure shows and where it differs: docs/gallery.md. Charts are drawn from the tables by tools/figures.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/progress.h"
#include "core/result.h"
#include "transport/bake_settings.h"

namespace airlight::figures {

// Words first, then numbers; a number that there is none of is NaN, and an empty cell.
struct Table {
    struct Row {
        std::vector<std::string> words;
        std::vector<double> numbers;
    };
    std::vector<std::string> columns;  // of both
    std::vector<Row> rows;

    // The column with a name, which must be there: [rows].
    std::vector<double> column(std::string_view name) const;
};

std::string csv(const Table& table);

// How finely a figure is computed, and where its pictures and tables of light go.
struct Settings {
    std::filesystem::path folder;
    int points = 241;  // along a curve
    BakeSettings bake = {.sizes = {.sun = 48, .azimuth = 8, .view = 32, .altitude = 24}, .orders = 5};
    int picture_width = 264;
    Progress progress = {};
};

// The same with little of everything, for tests.
Settings small(std::filesystem::path folder);

struct Figure {
    std::string_view name;
    std::string_view what;
    Result<Table> (*make)(const Settings& settings);
};

// In the order of docs/gallery.md.
std::span<const Figure> figures();
const Figure* find_figure(std::string_view name);

// Of density (profiles.cpp).
Result<Table> density_profile(const Settings& settings);
Result<Table> mean_density(const Settings& settings);
Result<Table> sky_columns(const Settings& settings);

// Of scattering (phases.cpp).
Result<Table> phase_functions(const Settings& settings);

// Of the sky as the eye climbs (altitude.cpp).
Result<Table> sky_by_altitude(const Settings& settings);
Result<Table> sky_from_altitudes(const Settings& settings);

// Of a planet with the air of Sperlhofer's thesis (planet.cpp).
Result<Table> scattering_orders(const Settings& settings);
Result<Table> rayleigh_coefficient(const Settings& settings);
Result<Table> rayleigh_scale_height(const Settings& settings);
Result<Table> mie_coefficient(const Settings& settings);
Result<Table> mie_scale_height(const Settings& settings);

}  // namespace airlight::figures
