#include "units/text.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <span>

namespace airlight {

namespace {

struct Unit {
    std::string_view name;
    double base;  // how many base units it is
};

constexpr Unit length_units[] = {{"m", 1.0}, {"km", 1e3}, {"um", 1e-6}, {"nm", 1e-9}, {"ft", 0.3048}, {"mi", 1609.344}};
constexpr Unit wavelength_units[] = {{"nm", 1.0}, {"um", 1e3}};
constexpr Unit angle_units[] = {{"deg", deg}, {"rad", 1.0}, {"arcmin", deg / 60.0}};
constexpr Unit inverse_length_units[] = {{"1/m", 1.0}, {"1/km", 1e-3}};

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
    return text;
}

Result<double> parse_with_units(std::string_view text, std::string_view what, std::span<const Unit> units) {
    const std::string_view whole = trimmed(text);
    double number = 0.0;
    const char* first = whole.data() + (whole.starts_with('+') ? 1 : 0);
    const auto [end, code] = std::from_chars(first, whole.data() + whole.size(), number);
    std::string names;
    for (const Unit& unit : units) names += (names.empty() ? "" : ", ") + std::string(unit.name);
    const std::string remedy = fmt::format("Write a number and a unit of {} ({}), such as \"8 {}\".", what, names, units.front().name);
    if (code != std::errc{} || !std::isfinite(number))
        return Error{"", fmt::format("\"{}\" does not begin with a finite number", text), remedy};
    const std::string_view name = trimmed(std::string_view(end, static_cast<std::size_t>(whole.data() + whole.size() - end)));
    if (name.empty()) return Error{"", fmt::format("\"{}\" has no unit", text), remedy};
    for (const Unit& unit : units)
        if (unit.name == name) return number * unit.base;
    return Error{"", fmt::format("\"{}\" is not in a unit of {}", text, what), remedy};
}

// "number unit" in the first unit in which the text reads back to `base_value`.
std::string text_in(double base_value, std::span<const Unit> units) {
    for (const Unit& unit : units) {
        const std::string text = fmt::format("{}", base_value / unit.base);
        double read = 0.0;
        std::from_chars(text.data(), text.data() + text.size(), read);
        if (read * unit.base == base_value) return fmt::format("{} {}", text, unit.name);
    }
    return fmt::format("{} {}", base_value, units.back().name);
}

}  // namespace

Result<double> parse_number(std::string_view text) {
    const std::string_view whole = trimmed(text);
    double number = 0.0;
    const char* first = whole.data() + (whole.starts_with('+') ? 1 : 0);
    const auto [end, code] = std::from_chars(first, whole.data() + whole.size(), number);
    if (code != std::errc{} || end != whole.data() + whole.size() || !std::isfinite(number))
        return Error{"", fmt::format("\"{}\" is not a finite number", text), ""};
    return number;
}

Result<Length> parse_length(std::string_view text) {
    const Result<double> value = parse_with_units(text, "length", length_units);
    if (!value) return value.error();
    return Length::of(*value);
}

Result<Wavelength> parse_wavelength(std::string_view text) {
    const Result<double> value = parse_with_units(text, "wavelength", wavelength_units);
    if (!value) return value.error();
    return Wavelength::of(*value);
}

Result<double> parse_angle(std::string_view text) { return parse_with_units(text, "angle", angle_units); }

Result<InverseLength> parse_inverse_length(std::string_view text) {
    const Result<double> value = parse_with_units(text, "inverse length", inverse_length_units);
    if (!value) return value.error();
    return InverseLength::of(*value);
}

std::string length_text(Length length) {
    constexpr Unit kilometres_first[] = {{"km", 1e3}, {"m", 1.0}};
    constexpr Unit metres_first[] = {{"m", 1.0}};
    return std::abs(length.value) >= 1000.0 ? text_in(length.value, kilometres_first) : text_in(length.value, metres_first);
}
std::string wavelength_text(Wavelength wavelength) {
    constexpr Unit nanometres[] = {{"nm", 1.0}};
    return text_in(wavelength.value, nanometres);
}
std::string angle_text(double radians) {
    constexpr Unit degrees_first[] = {{"deg", deg}, {"rad", 1.0}};
    return text_in(radians, degrees_first);
}
std::string inverse_length_text(InverseLength coefficient) {
    constexpr Unit per_metre[] = {{"1/m", 1.0}};
    return text_in(coefficient.value, per_metre);
}

}  // namespace airlight
