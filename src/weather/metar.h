// A METAR, the routine weather report of an aerodrome, as it is: nothing is filled in, nothing guessed.
// Its form: WMO-No. 306, FM 15 and FM 16 [WMO306], with the American and Canadian practices (miles, inches, RMK).
// docs/theory.md, section 8. Knows nothing of atmospheres.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "units/units.h"

namespace airlight {

enum class Bound { exact, at_least, less_than };

// A reported distance: "4000" is exact, "9999", "P6SM" and "10SM" are at least, "0000" and "M1/4SM" less than.
struct ReportedDistance {
    Length distance = 0.0 * m;
    Bound bound = Bound::exact;

    friend bool operator==(const ReportedDistance&, const ReportedDistance&) = default;
};

struct ReportedWind {
    std::optional<int> from_deg;                        // true degrees, 0 to 360, where it blows from; none: variable or not measured
    std::optional<double> speed_mps;                    // m/s
    std::optional<double> gust_mps;                     // m/s
    bool speed_at_least = false;                        // "P99KT": the speed is beyond the scale
    std::optional<int> varies_from_deg, varies_to_deg;  // "180V240", clockwise
};

// The visibility towards one side; `direction` is "N", "NE", ... or empty (the least, its side not said).
struct DirectionalVisibility {
    ReportedDistance visibility;
    std::string direction;
};

struct RunwayVisualRange {
    std::string runway;  // "06", "27L"
    std::optional<ReportedDistance> least;
    std::optional<ReportedDistance> most;  // only where it varies
    char tendency = ' ';                   // 'U' up, 'D' down, 'N' none, ' ' not said
};

enum class Intensity { light, moderate, heavy, vicinity };

// One group of present weather, in the letters of WMO code table 4678: "+TSRAGR" is heavy, "TS", {"RA", "GR"}.
struct PresentWeather {
    Intensity intensity = Intensity::moderate;
    std::string descriptor;              // MI BC PR DR BL SH TS FZ, or empty
    std::vector<std::string> phenomena;  // DZ RA SN SG IC PL GR GS UP, BR FG FU VA DU SA HZ PY, PO SQ FC SS DS

    bool has(std::string_view phenomenon) const;
};

enum class Cover { few, scattered, broken, overcast, sky_obscured, not_measured };  // 1-2, 3-4, 5-7, 8 eighths, VV

struct ReportedCloud {
    Cover cover = Cover::few;
    std::optional<Length> base;  // above the aerodrome; for an obscured sky the vertical visibility; none: not measured
    std::string kind;            // "CB", "TCU" or empty
};

enum class ReportKind { routine, special };  // METAR, SPECI

struct Metar {
    ReportKind kind = ReportKind::routine;
    std::string station;  // four letters or digits
    int day = 1;          // of the month, UTC, 1 to 31
    int hour = 0;
    int minute = 0;
    bool corrected = false;
    bool automatic = false;
    bool nil = false;  // the report is missing: nothing below is set

    std::optional<ReportedWind> wind;
    bool cavok = false;  // visibility at least 10 km, no cloud of importance, no weather
    std::optional<ReportedDistance> visibility;
    std::vector<DirectionalVisibility> directional_visibility;
    std::vector<RunwayVisualRange> runway_visual_range;
    std::vector<PresentWeather> weather;
    std::vector<PresentWeather> recent_weather;  // "RERA"
    std::vector<ReportedCloud> clouds;
    std::string no_cloud;                 // SKC, CLR, NSC or NCD where the report says so
    std::optional<double> temperature_c;  // to 0.1 where the remarks have it (T00561017)
    std::optional<double> dew_point_c;
    std::optional<double> qnh_hpa;                 // of Q1013 or A2992
    std::optional<double> sea_level_pressure_hpa;  // of SLP132 in the remarks
    std::vector<std::string> supplementary;        // wind shear, sea, state of runways, colour states: their text
    std::string trend;                             // "NOSIG", "BECMG ..." or "TEMPO ...", to the remarks
    std::string remarks;                           // all after RMK
};

// Reads one message, with or without "METAR" or "SPECI" before and '=' behind, over any number of lines; also the line
// "2003/10/17 19:53" that weather servers put before it. Missing groups ("////") are accepted and leave nothing set.
// Fails naming the first wrong group by number and text, the rule that it breaks, and the form that would be right.
Result<Metar> parse_metar(std::string_view message);

// What a two-letter code of table 4678 means, "RA": "rain"; empty if it is none.
std::string_view weather_meaning(std::string_view code);

// Relative humidity, 0 to 1; none if temperature or dew point is missing.
std::optional<double> relative_humidity(const Metar& metar);

}  // namespace airlight
