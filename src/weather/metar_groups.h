// The groups of a METAR's body: how each is recognised and read. Internal to parse_metar().
// docs/theory.md, section "Weather reports"; WMO-No. 306, FM 15 [WMO306].
#pragma once

#include <span>

#include "weather/metar.h"

namespace airlight {

// A group is of the first kind that it looks like (its unit, its first letters); `read` then stores it or says what is
// wrong with it, its text and place aside.
struct GroupKind {
    bool (*looks)(std::string_view group);
    Result<Done> (*read)(std::string_view group, Metar& metar);
};
std::span<const GroupKind> group_kinds();

// "-SHRA", "VCFG", "BR": one group of present weather, or nothing if it is none.
std::optional<PresentWeather> read_weather(std::string_view group);

// What the remarks say in figures: SLP132, T00561017.
void read_remarks(std::string_view remarks, Metar& metar);

}  // namespace airlight
