// Coefficients of fitted models as users supply them: CSV with comments (#) and a line that names the columns. Before it may stand
// what holds for the whole file, a line each: altitude_m = 20000.
// Every fault is an error with its line. Uses core and units; knows no model.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace airlight {

class CoefficientTable {
public:
    // Fails if the first line that is neither a comment nor stated does not name exactly these columns, or a row has another
    // number of cells.
    //   where   what errors name: the path of the file
    //   stated  the names of what may be stated for the whole file
    static Result<CoefficientTable> parse(std::string_view text, std::string_view where, std::span<const std::string_view> columns,
                                          std::span<const std::string_view> stated = {});

    // What is stated under a name; none if nothing is.
    std::optional<std::string> stated(std::string_view name) const;

    // The number stated under a name, or else `otherwise`. Fails unless it is a number from `low` to `high`.
    Result<double> stated_number(std::string_view name, double otherwise, double low, double high) const;

    std::size_t size() const { return rows_.size(); }
    const std::string& word(std::size_t row, std::size_t column) const { return rows_[row].cells[column]; }

    // Fails unless the cell is a finite number.
    Result<double> number(std::size_t row, std::size_t column) const;

    // The values of a column in every `stride`-th row from the first, until they no longer rise: an axis of a file that has its rows in order.
    // Fails unless they are within a range.
    Result<std::vector<double>> axis(std::size_t column, std::size_t stride, double low, double high) const;

    // Fails unless a cell of such a column has the value that its place asks for.
    Result<Done> expect(std::size_t row, std::size_t column, double value) const;

    // An error at a row; size() means the end of the table.
    Error error(std::size_t row, std::string what, std::string remedy = "") const;

private:
    struct Row {
        int line;
        std::vector<std::string> cells;
    };
    struct Stated {
        int line;
        std::string name, value;
    };
    const Stated* find(std::string_view name) const;

    std::string where_;
    std::vector<Stated> stated_;
    std::vector<std::string> columns_;
    std::vector<Row> rows_;
    int lines_ = 0;
};

// The altitude of the eye that a file of one altitude is for, stated as altitude_m; the ground if it states none.
inline constexpr std::string_view stated_altitude = "altitude_m";
Result<double> altitude_m_of(const CoefficientTable& table);

// A file's line that states it; none for the ground.
std::string altitude_line(double altitude_m);

// The text of a model's coefficients: of the file that the user gave, or else the fit that this project ships (data/<model>_fit.csv,
// compiled in). Fails, naming --data, if there is neither.
struct CoefficientText {
    std::string text;
    std::string where;  // for errors
};
Result<CoefficientText> coefficient_text(std::string_view model, const std::filesystem::path& given, std::string_view what_it_is);

}  // namespace airlight
