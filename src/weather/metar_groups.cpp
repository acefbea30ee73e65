#include "weather/metar_groups.h"

#include <fmt/format.h>

#include <array>

#include "core/scanner.h"

namespace airlight {

namespace {

constexpr Length foot = 0.3048 * m;
constexpr Length mile = 1609.344 * m;

bool starts_with_any(std::string_view text, std::initializer_list<std::string_view> words) {
    return std::any_of(words.begin(), words.end(), [&](std::string_view word) { return text.starts_with(word); });
}
bool is_any(std::string_view text, std::initializer_list<std::string_view> words) {
    return std::find(words.begin(), words.end(), text) != words.end();
}
bool digit_at(std::string_view text, std::size_t i) { return i < text.size() && Scanner::is_digit(text[i]); }
bool only_slashes(std::string_view text) { return text.find_first_not_of('/') == std::string_view::npos; }

// --- wind -----------------------------------------------------------------------------------------------------------

constexpr const char* wind_form = "Write it as 24015KT, 24015G25KT, VRB03KT or 09004MPS.";

Error wind_error(std::string what) { return {"", std::move(what), wind_form}; }

// KT, MPS or KMH, in metres a second.
std::optional<double> wind_unit(std::string_view unit) {
    if (unit == "KT") return 1852.0 / 3600.0;
    if (unit == "MPS") return 1.0;
    if (unit == "KMH") return 1.0 / 3.6;
    return {};
}

bool looks_like_wind(std::string_view group) { return group.ends_with("KT") || group.ends_with("MPS") || group.ends_with("KMH"); }

Result<Done> read_wind(std::string_view group, Metar& metar) {
    if (metar.wind) return wind_error("is a second wind");
    Scanner scanner(group);
    ReportedWind wind;
    if (!scanner.skip("VRB") && !scanner.skip("///")) {
        wind.from_deg = scanner.digits(3);
        if (!wind.from_deg) return wind_error("is not a wind: it begins with a direction of three digits, or VRB");
        if (*wind.from_deg > 360) return wind_error(fmt::format("is not a wind: direction {} is above 360", *wind.from_deg));
    }
    wind.speed_at_least = scanner.skip("P");
    const std::optional<int> speed = scanner.digits(2, 3);
    if (!speed && !scanner.skip("//")) return wind_error("is not a wind: after the direction comes a speed of two or three digits");
    std::optional<int> gust;
    if (scanner.skip("G")) {
        wind.speed_at_least |= scanner.skip("P");
        gust = scanner.digits(2, 3);
        if (!gust && !scanner.skip("//")) return wind_error("is not a wind: after G comes the gust in two or three digits");
    }
    const std::optional<double> unit = wind_unit(scanner.rest());
    if (!unit) return wind_error("is not a wind: after the speed comes its unit, KT, MPS or KMH");
    if (speed) wind.speed_mps = *speed * *unit;
    if (gust) wind.gust_mps = *gust * *unit;
    if (wind.speed_mps.value_or(0.0) > 150.0) return wind_error(fmt::format("is not a wind: {:.0f} m/s is above 150", *wind.speed_mps));
    metar.wind = wind;
    return Done{};
}

bool looks_like_wind_variation(std::string_view group) { return group.size() == 7 && group[3] == 'V' && digit_at(group, 0); }

Result<Done> read_wind_variation(std::string_view group, Metar& metar) {
    Scanner scanner(group);
    const auto from = scanner.digits(3);
    scanner.skip("V");
    const auto to = scanner.digits(3);
    const char* remedy = "Write it as 180V240, each 0 to 360.";
    if (!from || !to || *from > 360 || *to > 360) return Error{"", "is not a variation of the wind", remedy};
    if (!metar.wind) return Error{"", "is a variation of the wind, but no wind stands before it", remedy};
    metar.wind->varies_from_deg = from;
    metar.wind->varies_to_deg = to;
    return Done{};
}

// --- visibility -----------------------------------------------------------------------------------------------------

constexpr ReportedDistance ten_km_or_more{10.0 * km, Bound::at_least};

Error visibility_error(std::string what) { return {"", std::move(what), "Write it as 4000, 9999, 2000NE, CAVOK, 3SM, 1 1/2SM, M1/4SM or P6SM."}; }

Result<Done> keep_visibility(ReportedDistance visibility, Metar& metar) {
    if (metar.visibility) return visibility_error("is a second visibility");
    metar.visibility = visibility;
    return Done{};
}

Result<Done> read_cavok(std::string_view, Metar& metar) {
    metar.cavok = true;
    return keep_visibility(ten_km_or_more, metar);
}

// 9999 is 10 km or more, 0000 less than 50 m; the rest is what it says.
ReportedDistance metres(int figure) {
    if (figure == 9999) return ten_km_or_more;
    if (figure == 0) return {50.0 * m, Bound::less_than};
    return {figure * m, Bound::exact};
}

bool looks_like_metres(std::string_view group) { return digit_at(group, 0) && group.find('/') == std::string_view::npos; }

Result<Done> read_metres(std::string_view group, Metar& metar) {
    Scanner scanner(group);
    const auto figure = scanner.digits(4);
    if (!figure || scanner.at_digit()) return visibility_error("is not a visibility: in metres it has four digits");
    if (scanner.empty() && metar.visibility) {
        metar.directional_visibility.push_back({metres(*figure), ""});
        return Done{};
    }
    if (scanner.empty() || scanner.rest() == "NDV") return keep_visibility(metres(*figure), metar);
    if (!is_any(scanner.rest(), {"N", "NE", "E", "SE", "S", "SW", "W", "NW"}))
        return visibility_error("is not a visibility: after the metres stands NDV or a direction such as NE");
    metar.directional_visibility.push_back({metres(*figure), std::string(scanner.rest())});
    return Done{};
}

// "3", "1/2" or "1 1/2".
std::optional<double> read_mixed_number(Scanner& scanner) {
    const auto first = scanner.digits(1, 3);
    if (!first) return {};
    double whole = 0.0;
    std::optional<int> numerator = first;
    if (scanner.skip(" ")) {
        whole = *first;
        numerator = scanner.digits(1, 2);
    }
    if (!scanner.skip("/")) return whole == 0.0 && numerator ? std::optional<double>(*numerator) : std::nullopt;
    const auto denominator = scanner.digits(1, 2);
    if (!numerator || !denominator || *numerator >= *denominator) return {};
    return whole + static_cast<double>(*numerator) / *denominator;
}

bool looks_like_miles(std::string_view group) { return group.ends_with("SM"); }

Result<Done> read_miles(std::string_view group, Metar& metar) {
    if (group == "////SM") return Done{};
    Scanner scanner(group);
    const bool less = scanner.skip("M");
    const bool more = !less && scanner.skip("P");
    const auto miles = read_mixed_number(scanner);
    if (!miles || scanner.rest() != "SM" || *miles > 100.0) return visibility_error("is not a visibility in statute miles");
    const Bound bound = less ? Bound::less_than : (more || *miles >= 10.0) ? Bound::at_least : Bound::exact;
    return keep_visibility({*miles * mile, bound}, metar);
}

bool looks_like_kilometres(std::string_view group) { return digit_at(group, 0) && group.ends_with("KM"); }

Result<Done> read_kilometres(std::string_view group, Metar& metar) {
    Scanner scanner(group);
    const auto figure = scanner.digits(1, 2);
    if (!figure || scanner.rest() != "KM") return visibility_error("is not a visibility in kilometres");
    return keep_visibility({*figure * km, *figure >= 10 ? Bound::at_least : Bound::exact}, metar);
}

// --- runways --------------------------------------------------------------------------------------------------------

constexpr const char* runway_form = "Write a runway visual range as R06/1500, R06L/P1500N, R24/0400V1200U or R28/2600FT.";

std::optional<ReportedDistance> read_range(Scanner& scanner) {
    const Bound bound = scanner.skip("P") ? Bound::at_least : scanner.skip("M") ? Bound::less_than : Bound::exact;
    const auto figure = scanner.digits(4);
    if (!figure) return {};
    return ReportedDistance{*figure * m, bound};
}

bool is_runway_state(std::string_view text) {
    return starts_with_any(text, {"CLRD", "SNOCLO"}) || (text.size() == 6 && text.find_first_not_of("0123456789/") == std::string_view::npos);
}

bool looks_like_runway(std::string_view group) { return group.starts_with('R') && (digit_at(group, 1) || group.starts_with("R/")); }

Result<Done> read_runway(std::string_view group, Metar& metar) {
    const std::size_t slash = group.find('/');
    const std::string_view name = group.substr(1, slash == std::string_view::npos ? slash : slash - 1);
    const std::string_view value = slash == std::string_view::npos ? std::string_view() : group.substr(slash + 1);
    if (is_runway_state(value)) {
        metar.supplementary.emplace_back(group);
        return Done{};
    }
    Scanner runway(name);
    const auto number = runway.digits(2);
    if (!number || *number < 1 || *number > 36 || !is_any(runway.rest(), {"", "L", "C", "R", "LL", "RR"}))
        return Error{"", "does not name a runway: 01 to 36, and L, C or R", runway_form};
    RunwayVisualRange range;
    range.runway = name;
    Scanner scanner(value);
    if (!scanner.skip("////")) {
        range.least = read_range(scanner);
        if (!range.least) return Error{"", "is not a runway visual range: after '/' comes a range of four digits", runway_form};
        if (scanner.skip("V") && !(range.most = read_range(scanner)))
            return Error{"", "is not a runway visual range: after V comes a range of four digits", runway_form};
        const bool in_feet = scanner.skip("FT");
        if (in_feet) range.least->distance = range.least->distance.in(m) * foot;
        if (in_feet && range.most) range.most->distance = range.most->distance.in(m) * foot;
    }
    scanner.skip("/");
    for (const char tendency : {'U', 'D', 'N'})
        if (scanner.skip(std::string_view(&tendency, 1))) range.tendency = tendency;
    if (!scanner.empty()) return Error{"", fmt::format("is not a runway visual range: \"{}\" is left over", scanner.rest()), runway_form};
    metar.runway_visual_range.push_back(range);
    return Done{};
}

// --- clouds ---------------------------------------------------------------------------------------------------------

constexpr const char* cloud_form = "Write it as FEW020, SCT035CB, BKN040TCU, OVC///, VV002, NSC or CLR.";

struct CoverWord {
    std::string_view word;
    Cover cover;
};
constexpr std::array cover_words = {CoverWord{"FEW", Cover::few}, CoverWord{"SCT", Cover::scattered}, CoverWord{"BKN", Cover::broken},
                                    CoverWord{"OVC", Cover::overcast}, CoverWord{"VV", Cover::sky_obscured}, CoverWord{"///", Cover::not_measured}};

bool looks_like_cloud(std::string_view group) {
    return is_any(group, {"SKC", "CLR", "NSC", "NCD"}) || starts_with_any(group, {"FEW", "SCT", "BKN", "OVC", "VV", "///"});
}

Result<Done> read_cloud(std::string_view group, Metar& metar) {
    if (is_any(group, {"SKC", "CLR", "NSC", "NCD"})) {
        metar.no_cloud = group;
        return Done{};
    }
    ReportedCloud cloud;
    Scanner scanner(group);
    for (const CoverWord& c : cover_words)
        if (scanner.skip(c.word)) {
            cloud.cover = c.cover;
            break;
        }
    if (const auto hundreds_of_feet = scanner.digits(3)) cloud.base = *hundreds_of_feet * 100.0 * foot;
    else if (!scanner.skip("///")) return Error{"", "is not a cloud layer: after the cover comes its height in three digits", cloud_form};
    if (!scanner.empty() && !only_slashes(scanner.rest())) {
        if (!is_any(scanner.rest(), {"CB", "TCU"})) return Error{"", "is not a cloud layer: after the height only CB or TCU may stand", cloud_form};
        cloud.kind = scanner.rest();
    }
    metar.clouds.push_back(cloud);
    return Done{};
}

// --- temperature, pressure ------------------------------------------------------------------------------------------

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
    return slash != std::string_view::npos && slash <= 4 && (digit_at(group, 0) || group.front() == 'M' || starts_with_any(group, {"-", "XX/", "//"}));
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
        if (c.value && (*c.value < -95.0 || *c.value > 60.0)) return Error{"", fmt::format("is not a temperature: {} deg C is not on Earth", *c.value), form};
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
    if (!only_slashes(scanner.rest()) || (!figure && scanner.empty())) return Error{"", "is not a pressure: it has four digits", pressure_form};
    if (!figure) return Done{};
    const double hpa = inches ? *figure * 0.3386389 : *figure;  // inch of mercury at 0 deg C: 33.86389 hPa
    if (hpa < 850.0 || hpa > 1100.0) return Error{"", fmt::format("is not a pressure: {:.0f} hPa is outside 850 to 1100", hpa), pressure_form};
    if (!metar.qnh_hpa || !inches) metar.qnh_hpa = hpa;
    return Done{};
}

// --- the rest -------------------------------------------------------------------------------------------------------

bool looks_supplementary(std::string_view group) {
    const bool sea = group.starts_with('W') && (group.find("/S") != std::string_view::npos || group.find("/H") != std::string_view::npos);
    const bool old_runway_state = group.size() == 8 && digit_at(group, 0) && digit_at(group, 1) &&
                                  group.find_first_not_of("0123456789/CLRDSNO") == std::string_view::npos;
    return sea || old_runway_state || group.starts_with("WS ") || starts_with_any(group, {"BLACK"}) ||
           is_any(group, {"WS", "SNOCLO", "BLU", "BLU+", "WHT", "GRN", "YLO", "YLO1", "YLO2", "AMB", "RED"});
}

Result<Done> keep_supplementary(std::string_view group, Metar& metar) {
    metar.supplementary.emplace_back(group);
    return Done{};
}

bool looks_like_header_word(std::string_view group) { return is_any(group, {"AUTO", "COR", "RTD"}); }

Result<Done> read_header_word(std::string_view group, Metar& metar) {
    if (group == "AUTO") metar.automatic = true;
    if (group == "COR") metar.corrected = true;
    return Done{};
}

Result<Done> nothing_measured(std::string_view, Metar&) { return Done{}; }

bool looks_recent(std::string_view group) { return group.starts_with("RE") && (group == "RE//" || read_weather(group.substr(2))); }

Result<Done> read_recent(std::string_view group, Metar& metar) {
    if (const auto weather = read_weather(group.substr(2))) metar.recent_weather.push_back(*weather);
    return Done{};
}

Result<Done> read_present(std::string_view group, Metar& metar) {
    if (const auto weather = read_weather(group)) {
        metar.weather.push_back(*weather);
        return Done{};
    }
    return Error{"", "is no group of a METAR", "Weather is written in the codes of WMO table 4678, such as -RA, +TSRA, VCFG or BR; or leave it out."};
}

constexpr std::array kinds = {
    GroupKind{only_slashes, nothing_measured},
    GroupKind{looks_like_header_word, read_header_word},
    GroupKind{looks_like_wind, read_wind},
    GroupKind{looks_like_wind_variation, read_wind_variation},
    GroupKind{[](std::string_view group) { return group == "CAVOK"; }, read_cavok},
    GroupKind{looks_like_miles, read_miles},
    GroupKind{looks_like_kilometres, read_kilometres},
    GroupKind{looks_like_runway, read_runway},
    GroupKind{looks_supplementary, keep_supplementary},
    GroupKind{looks_like_metres, read_metres},
    GroupKind{looks_like_cloud, read_cloud},
    GroupKind{looks_like_pressure, read_pressure},
    GroupKind{looks_like_temperature, read_temperature},
    GroupKind{looks_recent, read_recent},
    GroupKind{[](std::string_view) { return true; }, read_present},
};

}  // namespace

std::span<const GroupKind> group_kinds() { return kinds; }

}  // namespace airlight
