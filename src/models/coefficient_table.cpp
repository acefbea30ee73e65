#include "models/coefficient_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/files.h"
#include "units/text.h"

namespace airlight {

namespace {

struct ShippedFit {
    std::string_view name, text;
};
// Not constexpr: compilers bound the length of a text that they measure while compiling.
const ShippedFit shipped[] = {
#include "shipped_fits.inc"
    {"", ""}  // an array has at least one
};

constexpr std::size_t largest_file = std::size_t{64} << 20;

std::vector<std::string> cells_of(std::string_view line) {
    std::vector<std::string> cells(1);
    for (const char c : line) {
        if (c == ',') cells.emplace_back();
        else cells.back() += c;
    }
    return cells;
}

// The next line without its end; the text is shortened by it.
std::string_view take_line(std::string_view& text) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
}

}  // namespace

Result<CoefficientTable> CoefficientTable::parse(std::string_view text, std::string_view where, std::span<const std::string_view> columns,
                                                 std::span<const std::string_view> stated) {
    CoefficientTable table;
    table.where_ = where;
    while (!text.empty()) {
        const std::string_view line = take_line(text);
        ++table.lines_;
        if (line.empty() || line.front() == '#') continue;
        std::vector<std::string> cells = cells_of(line);
        const std::string place = fmt::format("{}:{}", where, table.lines_);
        if (table.columns_.empty()) {
            if (const std::size_t is = line.find(" = "); is != std::string_view::npos) {
                const std::string_view name = line.substr(0, is);
                if (std::find(stated.begin(), stated.end(), name) == stated.end())
                    return Error{place, fmt::format("\"{}\" is nothing that this file may state", name.substr(0, 120)), ""};
                if (table.find(name)) return Error{place, fmt::format("{} is stated twice", name), ""};
                table.stated_.push_back({table.lines_, std::string(name), std::string(line.substr(is + 3))});
                continue;
            }
            if (!std::equal(cells.begin(), cells.end(), columns.begin(), columns.end()))
                return Error{place,
                             fmt::format("the columns are \"{}\": they must be \"{}\"", line.substr(0, 120), fmt::join(columns, ",")), ""};
            table.columns_ = std::move(cells);
            continue;
        }
        if (cells.size() != columns.size())
            return Error{place, fmt::format("has {} cells: it must have {}", cells.size(), columns.size()), ""};
        table.rows_.push_back({table.lines_, std::move(cells)});
    }
    if (table.columns_.empty()) return Error{std::string(where), "has no line that names its columns", ""};
    return table;
}

const CoefficientTable::Stated* CoefficientTable::find(std::string_view name) const {
    const auto found = std::find_if(stated_.begin(), stated_.end(), [&](const Stated& s) { return s.name == name; });
    return found == stated_.end() ? nullptr : &*found;
}

std::optional<std::string> CoefficientTable::stated(std::string_view name) const {
    const Stated* found = find(name);
    return found ? std::optional(found->value) : std::nullopt;
}

Result<double> CoefficientTable::stated_number(std::string_view name, double otherwise, double low, double high) const {
    const Stated* found = find(name);
    if (!found) return otherwise;
    const Result<double> value = parse_number(found->value);
    if (value && *value >= low && *value <= high) return *value;
    return Error{fmt::format("{}:{}", where_, found->line),
                 fmt::format("{} = {} is out of range: it must be a number from {:g} to {:g}", name, found->value, low, high), ""};
}

Result<double> CoefficientTable::number(std::size_t row, std::size_t column) const {
    const Result<double> value = parse_number(rows_[row].cells[column]);
    if (!value) return error(row, fmt::format("{} = \"{}\" is not a finite number", columns_[column], rows_[row].cells[column]));
    return *value;
}

Result<std::vector<double>> CoefficientTable::axis(std::size_t column, std::size_t stride, double low, double high) const {
    std::vector<double> values;
    for (std::size_t row = 0; row < size(); row += stride) {
        const Result<double> value = number(row, column);
        if (!value) return value.error();
        if (!(*value >= low && *value <= high))
            return error(row, fmt::format("{} = {:g} is out of range: it must be {:g} to {:g}", columns_[column], *value, low, high));
        if (!values.empty() && *value <= values.back()) break;
        values.push_back(*value);
    }
    return values;
}

Result<Done> CoefficientTable::expect(std::size_t row, std::size_t column, double value) const {
    const Result<double> there = number(row, column);
    if (!there) return there.error();
    if (*there == value) return Done{};
    return error(row, fmt::format("{} = {:g} is out of order: it must be {:g}", columns_[column], *there, value));
}

Error CoefficientTable::error(std::size_t row, std::string what, std::string remedy) const {
    return {fmt::format("{}:{}", where_, row < rows_.size() ? rows_[row].line : lines_), std::move(what), std::move(remedy)};
}

Result<double> altitude_m_of(const CoefficientTable& table) { return table.stated_number(stated_altitude, 0.0, 0.0, 1e9); }

std::string altitude_line(double altitude_m) { return altitude_m == 0.0 ? "" : fmt::format("{} = {}\n", stated_altitude, altitude_m); }

Result<CoefficientText> coefficient_text(std::string_view model, const std::filesystem::path& given, std::string_view what_it_is) {
    if (!given.empty()) {
        Result<std::string> text = read_file(given, largest_file);
        if (!text) return at("--data", text.error());
        return CoefficientText{std::move(*text), given.string()};
    }
    for (const ShippedFit& fit : shipped)
        if (fit.name == model) return CoefficientText{std::string(fit.text), fmt::format("{}_fit.csv", model)};
    return Error{std::string(model), "has no coefficients of its own here", fmt::format("Give {} by --data <file>.", what_it_is)};
}

}  // namespace airlight
