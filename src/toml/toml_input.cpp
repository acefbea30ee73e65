#include "toml/toml_input.h"

#include <algorithm>
#include <cmath>

#include "units/text.h"

namespace airlight {

namespace {

constexpr std::size_t longest_value_shown = 60;

// A value as a person would have written it, shortened and on one line.
std::string value_text(const toml::node& node) {
    if (node.is_table()) return "a table";
    if (node.is_array()) return "an array";
    if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
    if (const auto* number = node.as_integer()) return fmt::format("{}", number->get());
    if (const auto* truth = node.as_boolean()) return truth->get() ? "true" : "false";
    if (!node.is_string()) return "a date or time";
    std::string shown = node.as_string()->get().substr(0, longest_value_shown);
    for (char& c : shown)
        if (static_cast<unsigned char>(c) < 0x20) c = ' ';
    return '"' + shown + (node.as_string()->get().size() > longest_value_shown ? "..." : "") + '"';
}

unsigned line_of(const toml::node& node) { return static_cast<unsigned>(node.source().begin.line); }

}  // namespace

const toml::node* TomlInput::find(std::string_view key) {
    if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.emplace_back(key);
    return table_->get(key);
}

bool TomlInput::has(std::string_view key) { return find(key) != nullptr; }

bool TomlInput::is_text(std::string_view key) {
    const toml::node* node = find(key);
    return node && node->is_string();
}

bool TomlInput::is_table(std::string_view key) {
    const toml::node* node = find(key);
    return node && node->is_table();
}

unsigned TomlInput::line(std::string_view key) const {
    const toml::node* node = table_->get(key);
    return node ? line_of(*node) : line_of(*table_);
}

// Whether it is the first failure.
bool TomlInput::keep(unsigned line, std::string what, std::string_view remedy) {
    if (failure_->first) return false;
    const std::string where = line > 0 ? fmt::format("{}:{}", failure_->file, line) : failure_->file;
    failure_->first = Error{where, std::move(what), std::string(remedy)};
    return true;
}

void TomlInput::refuse(std::string_view key, std::string_view rule, std::string_view remedy) {
    const toml::node* node = table_->get(key);
    keep(line(key), fmt::format("{} = {}: {}", full(key), node ? value_text(*node) : "(absent)", rule), remedy);
}

void TomlInput::refuse_missing(std::string_view key, std::string_view remedy) {
    if (keep(line_of(*table_), fmt::format("{} is missing", full(key)), remedy)) missed_ = key;
}

void TomlInput::refuse_word(std::string_view key, std::string_view words) {
    const auto word = text(key);
    if (!word) return;
    const std::string near = nearest_word(*word, words);
    refuse(key, fmt::format("it must be one of: {}", words), near.empty() ? "" : fmt::format("Did you mean \"{}\"?", near));
}

void TomlInput::refuse_unknown_keys() {
    for (const auto& [key, node] : *table_) {
        const std::string_view name = key.str();
        if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
        std::string words;
        for (const std::string& known : known_) words += known + ' ';
        const std::string near = nearest_word(name, words);
        if (!near.empty() && near == missed_) failure_->first.reset();  // what is missing is there, misspelt
        const std::string remedy = near.empty() ? fmt::format("Keys here: {}.", words.substr(0, words.empty() ? 0 : words.size() - 1))
                                                : fmt::format("Did you mean \"{}\"?", near);
        keep(static_cast<unsigned>(key.source().begin.line), fmt::format("{} is no key that this table has", full(name)), remedy);
    }
}

bool TomlInput::element_number(std::string_view key, const toml::node& node, double& number) {
    const auto value = node.value<double>();
    const bool is_number = node.is_floating_point() || node.is_integer();
    if (is_number && value && std::isfinite(*value)) {
        number = *value;
        return true;
    }
    keep(line_of(node), fmt::format("{} has {} in it: it must hold finite numbers only", full(key), value_text(node)), "");
    return false;
}

std::optional<double> TomlInput::number(std::string_view key) {
    const toml::node* node = find(key);
    if (!node) return {};
    const auto value = node->value<double>();
    if ((node->is_floating_point() || node->is_integer()) && value && std::isfinite(*value)) return value;
    refuse(key, "it must be a finite number", "");
    return {};
}

std::optional<bool> TomlInput::truth(std::string_view key) {
    const toml::node* node = find(key);
    if (!node) return {};
    if (const auto* value = node->as_boolean()) return value->get();
    refuse(key, "it must be true or false", "");
    return {};
}

std::optional<std::string> TomlInput::text(std::string_view key) {
    const toml::node* node = find(key);
    if (!node) return {};
    if (const auto* value = node->as_string()) return value->get();
    refuse(key, "it must be a text in quotes", "");
    return {};
}

template <class T>
std::optional<T> TomlInput::quantity(std::string_view key, Result<T> (*parse)(std::string_view)) {
    if (has(key) && !is_text(key)) {
        refuse(key, "it must be a number and a unit in quotes", parse("") ? "" : parse("").error().remedy);
        return {};
    }
    const auto words = text(key);
    if (!words) return {};
    const Result<T> value = parse(*words);
    if (value) return *value;
    refuse(key, "it is not a quantity of this kind", value.error().remedy);
    return {};
}

std::optional<Length> TomlInput::length(std::string_view key) { return quantity(key, parse_length); }
std::optional<double> TomlInput::angle(std::string_view key) { return quantity(key, parse_angle); }
std::optional<InverseLength> TomlInput::inverse_length(std::string_view key) { return quantity(key, parse_inverse_length); }

std::optional<std::vector<double>> TomlInput::numbers(std::string_view key) {
    const toml::node* node = find(key);
    if (!node) return {};
    if (!node->is_array()) {
        refuse(key, "it must be an array of numbers", "");
        return {};
    }
    std::vector<double> values;
    for (const toml::node& element : *node->as_array())
        if (!element_number(key, element, values.emplace_back())) return {};
    return values;
}

std::optional<std::vector<std::vector<double>>> TomlInput::rows(std::string_view key) {
    const toml::node* node = find(key);
    if (!node) return {};
    std::vector<std::vector<double>> result;
    if (node->is_array())
        for (const toml::node& row : *node->as_array()) {
            if (!row.is_array()) break;
            auto& values = result.emplace_back();
            for (const toml::node& element : *row.as_array())
                if (!element_number(key, element, values.emplace_back())) return {};
        }
    if (node->is_array() && result.size() == node->as_array()->size()) return result;
    refuse(key, "it must be an array of arrays of numbers", "");
    return {};
}

std::optional<std::vector<std::string>> TomlInput::texts(std::string_view key) {
    const toml::node* node = find(key);
    if (!node) return {};
    std::vector<std::string> result;
    if (node->is_array())
        for (const toml::node& element : *node->as_array())
            if (const auto* value = element.as_string()) result.push_back(value->get());
    if (node->is_array() && result.size() == node->as_array()->size()) return result;
    refuse(key, "it must be an array of texts in quotes", "");
    return {};
}

std::optional<TomlInput> TomlInput::table(std::string_view key) {
    const toml::node* node = find(key);
    if (!node) return {};
    if (const auto* inner = node->as_table()) return TomlInput(*inner, full(key), *failure_);
    refuse(key, "it must be a table", fmt::format("Write [{}] on a line of its own, or {} = {{...}}.", full(key), key));
    return {};
}

std::vector<TomlInput> TomlInput::tables(std::string_view key) {
    std::vector<TomlInput> result;
    const toml::node* node = find(key);
    if (!node) return result;
    if (const auto* single = node->as_table()) result.emplace_back(*single, full(key), *failure_);
    if (const auto* array = node->as_array())
        for (const toml::node& element : *array)
            if (const auto* inner = element.as_table()) result.emplace_back(*inner, full(key), *failure_);
    const std::size_t wanted = node->is_array() ? node->as_array()->size() : 1;
    if (result.size() != wanted)
        refuse(key, "it must be one table or several", fmt::format("Write [[{}]] on a line of its own.", full(key)));
    return result;
}

Result<toml::table> parse_toml(std::string_view text, std::string_view file, std::string_view remedy) {
    try {
        return toml::parse(text);
    } catch (const toml::parse_error& error) {  // toml++ is built to throw; no exception leaves this function
        return Error{fmt::format("{}:{}", file, error.source().begin.line), fmt::format("it is not TOML: {}", error.description()),
                     std::string(remedy)};
    }
}

}  // namespace airlight
