// Which group is which, and those that need few words.

#include <array>

#include "core/scanner.h"
#include "weather/metar_groups.h"

namespace airlight {

namespace metar_group {

bool starts_with_any(std::string_view text, std::initializer_list<std::string_view> words) {
    return std::any_of(words.begin(), words.end(), [&](std::string_view word) { return text.starts_with(word); });
}

bool is_any(std::string_view text, std::initializer_list<std::string_view> words) {
    return std::find(words.begin(), words.end(), text) != words.end();
}

bool digit_at(std::string_view text, std::size_t i) { return i < text.size() && Scanner::is_digit(text[i]); }

bool only_slashes(std::string_view text) { return text.find_first_not_of('/') == std::string_view::npos; }

namespace {

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

// Slashes only: not measured. NSW, no significant weather; NDV after a blank.
bool says_nothing(std::string_view group) { return only_slashes(group) || is_any(group, {"NSW", "NDV"}); }

Result<Done> skip_group(std::string_view, Metar&) { return Done{}; }

bool looks_like_anything(std::string_view) { return true; }

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
    return Error{"", "is no group of a METAR",
                 "Weather is written in the codes of WMO table 4678, such as -RA, +TSRA, VCFG or BR; or leave it out."};
}

constinit const GroupKind nothing{says_nothing, skip_group};
constinit const GroupKind header_word{looks_like_header_word, read_header_word};
constinit const GroupKind supplementary{looks_supplementary, keep_supplementary};
constinit const GroupKind recent_weather{looks_recent, read_recent};
constinit const GroupKind present_weather{looks_like_anything, read_present};

constexpr std::array kinds = {&nothing, &header_word, &wind,        &wind_variation, &cavok,
                              &miles,   &kilometres,  &runway,      &supplementary,  &metres,
                              &cloud,   &pressure,    &temperature, &recent_weather, &present_weather};

}  // namespace

}  // namespace metar_group

Result<Done> read_group(std::string_view group, Metar& metar) {
    if (group.find_first_of("abcdefghijklmnopqrstuvwxyz") != std::string_view::npos)
        return Error{"", "is not in capital letters", "A METAR is written in capital letters and digits."};
    const auto kind = std::find_if(metar_group::kinds.begin(), metar_group::kinds.end(), [&](const auto* k) { return k->looks(group); });
    return (*kind)->read(group, metar);  // the last kind takes anything
}

}  // namespace airlight
