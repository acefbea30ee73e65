// A TOML table read key by key: the first thing that is wrong is kept, with its line, its key, its value and the rule.
// Uses core, units and toml++; knows nothing of atmospheres and scenes.
#pragma once

#include <fmt/format.h>

#include <toml++/toml.h>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "units/curve.h"
#include "units/units.h"

namespace airlight {

// The first error of a file; what is read after it is of no meaning.
struct TomlFailure {
    std::string file;
    std::optional<Error> first;
};

// One table. Every key that is asked for is known; the others are refused by refuse_unknown_keys().
// Each reader gives nothing if the key is absent, and nothing with a failure if its value is of the wrong kind.
class TomlInput {
public:
    // `path` is the key of the table itself, "" for the file's own; `failure` and `table` outlive this.
    TomlInput(const toml::table& table, std::string path, TomlFailure& failure)
        : table_(&table), path_(std::move(path)), failure_(&failure) {}

    void set_path(std::string path) { path_ = std::move(path); }
    bool has(std::string_view key);
    bool is_text(std::string_view key);
    bool is_table(std::string_view key);

    std::optional<double> number(std::string_view key);
    std::optional<bool> truth(std::string_view key);
    std::optional<std::string> text(std::string_view key);
    std::optional<Length> length(std::string_view key);
    std::optional<double> angle(std::string_view key);  // radians
    std::optional<InverseLength> inverse_length(std::string_view key);
    std::optional<std::vector<double>> numbers(std::string_view key);
    std::optional<std::vector<std::vector<double>>> rows(std::string_view key);
    std::optional<std::vector<std::string>> texts(std::string_view key);
    std::optional<TomlInput> table(std::string_view key);
    std::vector<TomlInput> tables(std::string_view key);  // [[key]], or [key] for one alone

    // A key that must be there: the reader's value, or a failure that says what to write.
    template <class T>
    std::optional<T> need(std::optional<T> (TomlInput::*read)(std::string_view), std::string_view key, std::string_view remedy) {
        if (!has(key)) refuse_missing(key, remedy);
        return (this->*read)(key);
    }

    // Keeps the failure `path.key = value: rule`, unless there is one already.
    void refuse(std::string_view key, std::string_view rule, std::string_view remedy);
    void refuse_missing(std::string_view key, std::string_view remedy);
    // `value` is none of the words (separated by spaces); the nearest one is named.
    void refuse_word(std::string_view key, std::string_view words);
    void refuse_unknown_keys();
    bool failed() const { return failure_->first.has_value(); }
    TomlFailure& failure() const { return *failure_; }

    // The line of a key of this table, or of the table where the key is absent; 0 if it is not from a file.
    unsigned line(std::string_view key) const;

private:
    const toml::node* find(std::string_view key);
    std::string full(std::string_view key) const { return path_.empty() ? std::string(key) : path_ + '.' + std::string(key); }
    bool keep(unsigned line, std::string what, std::string_view remedy);
    template <class T>
    std::optional<T> quantity(std::string_view key, Result<T> (*parse)(std::string_view));
    bool element_number(std::string_view key, const toml::node& node, double& number);

    const toml::table* table_;
    std::string path_;
    TomlFailure* failure_;
    std::vector<std::string> known_;
    std::string missed_;  // the key whose absence is the failure
};

// A curve from two arrays of one table: x in the unit of `x_key`, y in that of `y_key`.
template <class X, class Y>
std::optional<Curve<X, Y>> read_curve(TomlInput& table, std::string_view x_key, X x_unit, std::string_view y_key, Y y_unit) {
    const std::string remedy = fmt::format("Give {} and {}, two arrays of the same length.", x_key, y_key);
    const auto x = table.need(&TomlInput::numbers, x_key, remedy);
    const auto y = table.need(&TomlInput::numbers, y_key, remedy);
    if (!x || !y) return {};
    if (x->size() != y->size()) {
        table.refuse(y_key, fmt::format("it has {} values, but {} has {}", y->size(), x_key, x->size()), remedy);
        return {};
    }
    std::vector<typename Curve<X, Y>::Sample> samples;
    for (std::size_t i = 0; i < x->size(); ++i) samples.push_back({(*x)[i] * x_unit, (*y)[i] * y_unit});
    Result<Curve<X, Y>> curve = Curve<X, Y>::of(std::move(samples));
    if (curve) return *curve;
    table.refuse(x_key, curve.error().what, curve.error().remedy);
    return {};
}

// A file's text as a table; fails with its line if it is not TOML.
Result<toml::table> parse_toml(std::string_view text, std::string_view file, std::string_view remedy);

}  // namespace airlight
