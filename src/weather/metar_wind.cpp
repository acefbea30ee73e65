// The wind and its variation.

#include <fmt/format.h>

#include "core/scanner.h"
#include "weather/metar_groups.h"

namespace airlight::metar_group {

namespace {

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

}  // namespace

constinit const GroupKind wind{looks_like_wind, read_wind};
constinit const GroupKind wind_variation{looks_like_wind_variation, read_wind_variation};

}  // namespace airlight::metar_group
