// Tables of independent figures, read from a folder beside the checkout.
// The folder is ../shared/reference, or what AIRLIGHT_REFERENCE names; tests are skipped, saying so, where it is absent.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace airlight::truth {

// A row by column name; what is no number reads as text().
class Row {
public:
    std::map<std::string, std::string> cells;
    double operator[](const std::string& column) const { return std::strtod(cells.at(column).c_str(), nullptr); }
    const std::string& text(const std::string& column) const { return cells.at(column); }
};

inline std::filesystem::path folder() {
    if (const char* given = std::getenv("AIRLIGHT_REFERENCE")) return given;
    return std::filesystem::path(AIRLIGHT_SOURCE_DIR) / "../shared/reference";
}

// The rows of a CSV file whose first line that is no comment names the columns; none if the file is absent.
inline std::vector<Row> rows(const std::string& name) {
    std::ifstream file(folder() / name);
    std::vector<Row> result;
    std::vector<std::string> columns;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#') continue;
        std::vector<std::string> cells;
        std::stringstream stream(line);
        for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
        if (columns.empty()) {
            columns = cells;
            continue;
        }
        Row row;
        for (std::size_t i = 0; i < columns.size() && i < cells.size(); ++i) row.cells[columns[i]] = cells[i];
        result.push_back(std::move(row));
    }
    return result;
}

// The light version of a truth test runs with every other test; `make truth` sets AIRLIGHT_TRUTH=full.
inline bool full() {
    const char* value = std::getenv("AIRLIGHT_TRUTH");
    return value && std::string(value) == "full";
}

}  // namespace airlight::truth
