// Temperature with dew point, and pressure.

#include <fmt/format.h>

#include "core/scanner.h"
#include "weather/metar_groups.h"

namespace airlight::metar_group {

namespace {

struct ReportedCelsius {
    bool valid = false;
    std::optional<double> value;
};

ReportedCelsius read_celsius(std::string_view text) {
    if (only_slashes(text) || text == "XX") return {true, {}};
    Scanner scanner(text);
    const bool negative = scanner.skip("M");
    const auto degrees = scanner.digits(2);
    if (!degrees || !(scanner.empty() || only_slashes(scanner.rest()))) return {};
    return {true, negative ? -*degrees : *degrees};
}

bool looks_like_temperature(std::string_view group) {
    const std::size_t slash = group.find('/');
    return slash != std::string_view::npos && slash <= 4 &&
           (digit_at(group, 0) || group.front() == 'M' || starts_with_any(group, {"-", "XX/", "//"}));
}

Result<Done> read_temperature(std::string_view group, Metar& metar) {
    const char* form = "Write temperature and dew point as 18/09 or M05/M07, in whole degrees of two digits.";
    if (metar.temperature_c) return Error{"", "is a second temperature", form};
    std::size_t slash = group.find('/');
    if (slash == 0) slash = group.find_last_of('/');  // "///M07"
    const ReportedCelsius temperature = read_celsius(group.substr(0, slash));
    const ReportedCelsius dew_point = read_celsius(group.substr(slash + 1));
    if (!temperature.valid || !dew_point.valid) return Error{"", "is not a temperature and a dew point", form};
    for (const ReportedCelsius& c : {temperature, dew_point})
        if (c.value && (*c.value < -95.0 || *c.value > 60.0))
            return Error{"", fmt::format("is not a temperature: {} deg C is not on Earth", *c.value), form};
    // Rounded to whole degrees and measured apart, they may cross by a little.
    if (temperature.value && dew_point.value && *dew_point.value > *temperature.value + 2.0)
        return Error{"", fmt::format("has a dew point of {} deg C above its temperature", *dew_point.value), form};
    metar.temperature_c = temperature.value;
    metar.dew_point_c = dew_point.value;
    return Done{};
}

constexpr const char* pressure_form = "Write it as Q1013 (hPa) or A2992 (hundredths of an inch of mercury).";

bool looks_like_pressure(std::string_view group) {
    return (group.starts_with('Q') || group.starts_with('A')) && (digit_at(group, 1) || group.starts_with("Q/") || group.starts_with("A/"));
}

Result<Done> read_pressure(std::string_view group, Metar& metar) {
    Scanner scanner(group);
    const bool inches = scanner.take(1) == "A";
    const auto figure = scanner.digits(4);
    if (!only_slashes(scanner.rest()) || (!figure && scanner.empty()))
        return Error{"", "is not a pressure: it has four digits", pressure_form};
    if (!figure) return Done{};
    const double hpa = inches ? *figure * 0.3386389 : *figure;  // inch of mercury at 0 deg C: 33.86389 hPa
    if (hpa < 850.0 || hpa > 1100.0)
        return Error{"", fmt::format("is not a pressure: {:.0f} hPa is outside 850 to 1100", hpa), pressure_form};
    if (!metar.qnh_hpa || !inches) metar.qnh_hpa = hpa;
    return Done{};
}

}  // namespace

constinit const GroupKind temperature{looks_like_temperature, read_temperature};
constinit const GroupKind pressure{looks_like_pressure, read_pressure};

}  // namespace airlight::metar_group
