// Coefficients of fitted models as users supply them: CSV with comments (#) and a line that names the columns.
// Every fault is an error with its line. Uses core and units; knows no model.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace airlight {

class CoefficientTable {
public:
    // Fails if the first line that is no comment does not name exactly these columns, or a row has another number of cells.
    //   where  what errors name: the path of the file
    static Result<CoefficientTable> parse(std::string_view text, std::string_view where, std::span<const std::string_view> columns);

    std::size_t size() const { return rows_.size(); }
    const std::string& word(std::size_t row, std::size_t column) const { return rows_[row].cells[column]; }

    // Fails unless the cell is a finite number.
    Result<double> number(std::size_t row, std::size_t column) const;

    // An error at a row; size() means the end of the table.
    Error error(std::size_t row, std::string what, std::string remedy = "") const;

private:
    struct Row {
        int line;
        std::vector<std::string> cells;
    };
    std::string where_;
    std::vector<std::string> columns_;
    std::vector<Row> rows_;
    int lines_ = 0;
};

// The text of a model's coefficients: of the file that the user gave, or else the fit that this project ships (data/<model>_fit.csv,
// compiled in). Fails, naming --data, if there is neither.
struct CoefficientText {
    std::string text;
    std::string where;  // for errors
};
Result<CoefficientText> coefficient_text(std::string_view model, const std::filesystem::path& given, std::string_view what_it_is);

}  // namespace airlight
