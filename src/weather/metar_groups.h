// The groups of a METAR's body: how each is recognised and read. Internal to parse_metar().
// docs/theory.md, section 8; WMO-No. 306, FM 15 [WMO306].
#pragma once

#include <initializer_list>

#include "weather/metar.h"

namespace airlight {

// Stores one group of the body in `metar`, or says what is wrong with it, its text and place aside.
Result<Done> read_group(std::string_view group, Metar& metar);

// "-SHRA", "VCFG", "BR": one group of present weather, or nothing if it is none.
std::optional<PresentWeather> read_weather(std::string_view group);

// What the remarks say in figures: SLP132, T00561017.
void read_remarks(std::string_view remarks, Metar& metar);

namespace metar_group {

// A group is of the first kind that it looks like (its unit, its first letters); `read` then stores or refuses it.
struct GroupKind {
    bool (*looks)(std::string_view group);
    Result<Done> (*read)(std::string_view group, Metar& metar);
};
extern const GroupKind wind, wind_variation;              // metar_wind.cpp
extern const GroupKind cavok, miles, kilometres, metres;  // metar_visibility.cpp
extern const GroupKind runway;                            // metar_runway.cpp
extern const GroupKind cloud;                             // metar_cloud.cpp
extern const GroupKind temperature, pressure;             // metar_air.cpp

bool starts_with_any(std::string_view text, std::initializer_list<std::string_view> words);
bool is_any(std::string_view text, std::initializer_list<std::string_view> words);
bool digit_at(std::string_view text, std::size_t i);
bool only_slashes(std::string_view text);

}  // namespace metar_group

}  // namespace airlight
